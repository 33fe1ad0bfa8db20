import * as engine from "../engine";
import type { Run } from "../run";
import type { Scenario } from "../scenario";
import { scheduleCompute } from "./frames";
import { History } from "./history";
import { decodeLink, encodeLink, firstMissing, LinkError } from "./link";

interface Entry {
  scenario: Scenario;
  /** What the edit that led here did, as the start of a sentence: "Anchor 2 moved". */
  what: string;
}

/** The state everybody reads: the scenario, its run, what is wrong, what changed. Edits go through here. */
export class Session {
  scenario: Scenario = $state.raw()!;
  run: Run | null = $state.raw(null);
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
  #describe: (run: Run) => string;
  #linkTurn = 0;
  #pendingWhat: string | null = "Ready";
  #pendingFit = false;

  constructor(scenario: Scenario, describe: (run: Run) => string) {
    this.#history = new History({ scenario, what: "Opened" });
    this.#describe = describe;
    this.scenario = scenario;
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
      this.refusal = `${problems[0].message} The scenario stays as it was.`;
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
      const scenario = await readLink(hash, this.scenario);
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
      this.run = engine.track(this.scenario);
      this.failure = null;
    } catch (error) {
      this.failure = `${sentenceOf(error)} The last good run stays on the screen.`;
    }
    if (this.#pendingFit) this.opened += 1;
    this.#pendingFit = false;
    if (this.#pendingWhat === null) return;
    this.announcement = this.run ? `${this.#pendingWhat}. ${this.#describe(this.run)}` : this.#pendingWhat;
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
export async function readLink(hash: string, template: Scenario): Promise<Scenario> {
  const scenario = await decodeLink(hash);
  const [problem] = engine.validate(scenario);
  if (problem) throw new LinkError(`This link holds a scenario that does not work: ${problem.message}`);
  const missing = firstMissing(template, scenario);
  if (missing)
    throw new LinkError(`This link leaves out “${missing}”; the page reads complete scenarios only.`);
  return scenario as Scenario;
}

export function sentenceOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

function lowerFirst(text: string): string {
  return text.charAt(0).toLowerCase() + text.slice(1);
}
