import * as engine from "../engine";
import type { Lab, LabRun } from "../lab";
import { forLab, labOf } from "../labs";
import type { Scenario } from "../scenario";
import { scheduleCompute } from "./frames";
import { History } from "./history";
import { decodeLink, encodeLink, firstMissing, LinkError } from "./link";

interface Entry {
  scenario: Scenario;
  /** What the edit that led here did, as the start of a sentence: "Anchor 2 moved". */
  what: string;
}

/** The state everybody reads: the scenario, its lab and run, what is wrong, what changed. Edits go through here. */
export class Session<R extends LabRun = LabRun> {
  readonly labs: readonly Lab[];
  scenario: Scenario = $state.raw()!;
  /** The lab that the scenario is for. */
  lab: Lab = $state.raw()!;
  run: R | null = $state.raw(null);
  /** Why the engine has no run for the scenario; the last good one stays. */
  failure: string | null = $state(null);
  /** Why the last edit or link was not taken; gone with the next one that is. */
  refusal: string | null = $state(null);
  /** One sentence about what changed, for the live region. */
  announcement = $state("");
  selectedAnchor: number | null = $state(null);
  canUndo = $state(false);
  canRedo = $state(false);
  /** Counts runs of scenarios that replaced the whole scene (preset, link): the camera then fits again. */
  opened = $state(0);
  link = $state("");
  #history: History<Entry>;
  /** The last scene of each lab one has been in. */
  #left: Record<string, Scenario> = {};
  #linkTurn = 0;
  #pendingWhat: string | null = "Ready";
  #pendingFit = false;

  constructor(scenario: Scenario, labs: readonly Lab[]) {
    this.labs = labs;
    this.#history = new History({ scenario, what: "Opened" });
    this.scenario = scenario;
    this.lab = labOf(scenario, labs) ?? labs[0];
    this.#compute();
  }

  /** Shows an edit in progress; `commit` makes it one entry of the history. */
  preview(what: string, next: Scenario): void {
    this.#history.preview({ scenario: next, what });
    this.#show();
  }

  /** Ends the edit in progress. An edit that leaves a bad scenario is taken back, with the reason. */
  commit(): boolean {
    const problems = engine.validate(this.#history.present.scenario);
    if (problems.length > 0) {
      this.#history.cancel();
      this.#show();
      this.refusal = `${problems[0].message}. The scenario stays as it was.`;
      return false;
    }
    this.refusal = null;
    this.#history.commit();
    this.#show();
    this.#announce(this.#history.present.what);
    return true;
  }

  /** One edit, or the last state of the one in progress. */
  edit(what: string, next: Scenario): boolean {
    this.#history.preview({ scenario: next, what });
    return this.commit();
  }

  /** An edit that replaces the scene as a whole. */
  open(what: string, next: Scenario): boolean {
    this.selectedAnchor = null;
    const accepted = this.edit(what, next);
    this.#pendingFit ||= accepted;
    return accepted;
  }

  /** Opens one of the lab's own scenarios. */
  openPreset(name: string): boolean {
    const entry = this.lab.presets().find((candidate) => candidate.name === name);
    if (!entry) return false;
    const scenario = forLab(this.lab.preset(name), this.lab, this.labs);
    return this.open(`Preset “${entry.title}” opened`, scenario);
  }

  /** Goes to another lab: to the scene one left there, else to its first preset. */
  openLab(lab: Lab): boolean {
    this.#left[this.lab.name] = this.scenario;
    const scenario = this.#left[lab.name] ?? forLab(lab.preset(lab.firstPreset), lab, this.labs);
    return this.open(`Lab ${lab.title} opened`, scenario);
  }

  undo(): void {
    const undone = this.#history.undo();
    if (undone) this.#travel(`Undone: ${lowerFirst(undone.what)}`);
  }

  redo(): void {
    const redone = this.#history.redo();
    if (redone) this.#travel(`Done again: ${lowerFirst(redone.what)}`);
  }

  /** Opens the scenario of a link; a bad one is told in a sentence and changes nothing. */
  async openLink(hash: string): Promise<boolean> {
    try {
      const scenario = await readLink(hash, this.labs);
      return this.open("Scenario opened from the link", scenario);
    } catch (error) {
      this.refusal = `${sentenceOf(error)} The scene shown is not the link's.`;
      return false;
    }
  }

  #travel(what: string): void {
    const anchors = this.#history.present.scenario.anchors.length;
    if (this.selectedAnchor !== null && this.selectedAnchor >= anchors) this.selectedAnchor = null;
    this.refusal = null;
    this.#show();
    this.#announce(what);
  }

  #show(): void {
    this.scenario = this.#history.present.scenario;
    const lab = labOf(this.scenario, this.labs) ?? this.lab;
    // A run means nothing to another lab than its own.
    if (lab !== this.lab) this.run = null;
    this.lab = lab;
    this.canUndo = this.#history.canUndo;
    this.canRedo = this.#history.canRedo;
    scheduleCompute(this.#compute);
  }

  #announce(what: string): void {
    this.#pendingWhat = what;
    void this.#writeLink();
  }

  #compute = (): void => {
    try {
      this.run = this.lab.compute(this.scenario) as R;
      this.failure = null;
    } catch (error) {
      this.failure = `${sentenceOf(error)} The last good run stays on the screen.`;
    }
    if (this.#pendingFit) this.opened += 1;
    this.#pendingFit = false;
    if (this.#pendingWhat === null) return;
    this.announcement = this.run ? `${this.#pendingWhat}. ${this.lab.describe(this.run)}` : this.#pendingWhat;
    this.#pendingWhat = null;
  };

  async #writeLink(): Promise<void> {
    const turn = ++this.#linkTurn;
    const link = await encodeLink(this.scenario);
    if (turn !== this.#linkTurn) return;
    this.link = link;
    history.replaceState(null, "", link);
  }
}

/** The scenario a link carries; throws with a sentence where the link or the scenario is bad. */
export async function readLink(hash: string, labs: readonly Lab[]): Promise<Scenario> {
  const scenario = await decodeLink(hash);
  const [problem] = engine.validate(scenario);
  if (problem) throw new LinkError(`This link holds a scenario that does not work: ${problem.message}`);
  const missing = firstMissing(labs[0].preset(labs[0].firstPreset), scenario);
  if (missing)
    throw new LinkError(`This link leaves out “${missing}”; the page reads complete scenarios only.`);
  const complete = scenario as Scenario;
  if (!labOf(complete, labs))
    throw new LinkError(
      `This link is for the lab “${complete.view?.["lab"]}”, which this page does not have.`,
    );
  return complete;
}

export function sentenceOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

function lowerFirst(text: string): string {
  return text.charAt(0).toLowerCase() + text.slice(1);
}
