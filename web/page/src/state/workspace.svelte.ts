import { getContext, setContext } from "svelte";
import { MediaQuery } from "svelte/reactivity";
import type { Lab, LabRun } from "../lab";
import { applyTheme, type Palette, readPalette, type Theme } from "../theme/palette";
import type { Session } from "./session.svelte";
import { keep } from "./storage";
import type { Thing } from "./things";
import { Timeline } from "./timeline.svelte";

const narrow = new MediaQuery("max-width: 700px");
const medium = new MediaQuery("max-width: 1100px");

/** What every part of the frame shares: the scenario, its lab and run, the time cursor, the looks. */
export class Workspace<R extends LabRun = LabRun> {
  readonly timeline = new Timeline();
  theme: Theme = $state("light");
  palette: Palette = $state.raw()!;
  /** What is under the pointer. */
  hovered: Thing | null = $state(null);
  /** The one estimator that stands out in the plots, or null. */
  emphasis: string | null = $state(null);

  /** How much room there is: it decides where the numbers stand. */
  get room(): "narrow" | "medium" | "wide" {
    return narrow.current ? "narrow" : medium.current ? "medium" : "wide";
  }

  get lab(): Lab {
    return this.session.lab;
  }

  constructor(
    readonly session: Session<R>,
    theme: Theme,
  ) {
    this.#showTheme(theme);
  }

  /** Lets an estimator stand out, or all be equal again. */
  emphasize(name: string): void {
    this.emphasis = this.emphasis === name ? null : name;
  }

  setTheme(theme: Theme): void {
    keep("theme", theme);
    this.#showTheme(theme);
  }

  #showTheme(theme: Theme): void {
    applyTheme(theme);
    this.theme = theme;
    this.palette = readPalette(theme);
  }
}

const KEY = Symbol("workspace");

export function provideWorkspace(workspace: Workspace): Workspace {
  return setContext(KEY, workspace);
}

/** A lab's own parts know what its runs are: `useWorkspace<Run>()`. */
export function useWorkspace<R extends LabRun = LabRun>(): Workspace<R> {
  return getContext(KEY);
}
