import { getContext, setContext } from "svelte";
import { MediaQuery } from "svelte/reactivity";
import type { SceneDocument } from "../family";
import type { Lab, LabRun } from "../lab";
import type { Ray } from "../scene/view";
import {
  applyTheme,
  type Palette,
  readPalette,
  type Theme,
  type ThemeChoice,
  themeOf,
} from "../theme/palette";
import { Exports } from "./exports.svelte";
import { Faults } from "./faults.svelte";
import { Layout } from "./layout.svelte";
import type { StudyPicture } from "./study.svelte";
import type { Session } from "./session.svelte";
import { keep } from "./storage";
import type { Thing } from "./things";
import { Timeline } from "./timeline.svelte";

const narrow = new MediaQuery("(max-width: 700px) or (max-height: 480px)");
const medium = new MediaQuery("max-width: 1100px");
const dark = new MediaQuery("prefers-color-scheme: dark");

const NO_TIMES = new Float64Array();

/** What every part of the frame shares: the scenario, its lab and run, the time cursor, the looks. */
export class Workspace<R extends LabRun = LabRun, S extends SceneDocument = SceneDocument> {
  readonly timeline: Timeline = new Timeline(() => this.session.run?.times ?? NO_TIMES);
  readonly layout = new Layout();
  readonly exports = new Exports();
  readonly faults = new Faults();
  themeChoice: ThemeChoice = $state("system");
  theme: Theme = $derived(themeOf(this.themeChoice, dark.current));
  /** The style sheet shows the theme before its colours are read. */
  palette: Palette = $derived.by(() => {
    applyTheme(this.theme);
    return readPalette(this.theme);
  });
  helpOpen = $state(false);
  /** Whether the papers' figures are asked for. */
  figuresOpen = $state(false);
  /** What is under the pointer. */
  hovered: Thing | null = $state(null);
  /** The line of sight through the pointer, while it is over the scene of a lab with a field. */
  ray: Ray | null = $state.raw(null);
  /**
   * Averages over many trials, while the plots show them: the lab that they are of, whether they are over time, and
   * whether of an earlier scenario.
   */
  averages: { lab: Lab; picture: StudyPicture; overTime: boolean; stale: boolean } | null = $state.raw(null);
  /** The one estimator that stands out, and the lab that it is of. */
  #emphasized: { lab: Lab; name: string } | null = $state.raw(null);

  /** How much room there is: it decides where the numbers stand. */
  get room(): "narrow" | "medium" | "wide" {
    return narrow.current ? "narrow" : medium.current ? "medium" : "wide";
  }

  get lab(): Lab {
    return this.session.lab;
  }

  /** The averages over time that are shown; never those of another lab, of which this one knows nothing. */
  get study(): StudyPicture | null {
    return this.#averages(true);
  }

  /** The averages of a page of their own, which say nothing about the errors at a step. */
  get studyPage(): StudyPicture | null {
    return this.#averages(false);
  }

  #averages(overTime: boolean): StudyPicture | null {
    const shown = this.averages;
    return shown?.lab === this.lab && shown.overTime === overTime ? shown.picture : null;
  }

  /** Whether the averages shown are of an earlier scenario: new ones are on their way. */
  get studyStale(): boolean {
    return this.study !== null && this.averages!.stale;
  }

  constructor(
    readonly session: Session<R, S>,
    themeChoice: ThemeChoice,
  ) {
    this.themeChoice = themeChoice;
  }

  /** The one estimator that stands out in the plots, or null. */
  get emphasis(): string | null {
    return this.#emphasized?.lab === this.lab ? this.#emphasized.name : null;
  }

  /** Lets an estimator stand out, or all be equal again. */
  emphasize(name: string): void {
    this.#emphasized = this.emphasis === name ? null : { lab: this.lab, name };
  }

  setTheme(choice: ThemeChoice): void {
    keep("theme", choice);
    this.themeChoice = choice;
  }
}

const KEY = Symbol("workspace");

export function provideWorkspace(workspace: Workspace): Workspace {
  return setContext(KEY, workspace);
}

/** A lab's own parts know what its runs and documents are: `useWorkspace<Run, Scenario>()`. */
export function useWorkspace<R extends LabRun = LabRun, S extends SceneDocument = SceneDocument>(): Workspace<
  R,
  S
> {
  return getContext(KEY);
}
