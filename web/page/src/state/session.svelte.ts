import * as engine from "../engine";
import type { Room, SceneDocument } from "../family";
import { forLab, type Lab, labOf, type LabRun } from "../lab";
import { lowerFirst, startOf } from "../words";
import { notLoaded, readDocument, readLink, readText, sentenceOf, textOf } from "./document";
import { scheduleCompute } from "./frames";
import { History } from "./history";
import { Keeper } from "./keeper";
import { LabLoader } from "./lab-loader.svelte";
import { existing, type Thing } from "./things";

interface Entry<S> {
  scenario: S;
  /** What the edit that led here did, as the start of a sentence: "Anchor 2 moved". */
  what: string;
}

/** The scenario twice and what stood before it: an engine that breaks over all of these breaks over anything. */
const MOST_TRAPS = 3;

/** The state everybody reads: the scenario, its lab and run, what is wrong, what changed. Edits go through here. */
export class Session<R extends LabRun = LabRun, S extends SceneDocument = SceneDocument> {
  readonly labs: readonly Lab[];
  scenario: S = $state.raw()!;
  /** The lab that the scenario is for. */
  lab: Lab = $state.raw()!;
  /** What stands in the scene, whatever kind of document it is. */
  readonly room: Room = $derived.by(() => this.lab.family.room(this.scenario));
  run: R | null = $state.raw(null);
  /** The scenario that the run is of: while one drags, and where a run failed, not the one at hand. */
  computed: S | null = $state.raw(null);
  /** Why the engine has no run for the scenario; the last good one stays. */
  failure: string | null = $state(null);
  /** Why the last edit, link or file was not taken; gone with the next edit that is. */
  refusal: string | null = $state(null);
  /** One sentence about what changed, for the live region. */
  announcement = $state("");
  /** The scene is the one of the last visit; said until the first edit. */
  restored = $state(false);
  /** What is chosen in the scene; moved, typed and removed together. */
  selected: readonly Thing[] = $state.raw([]);
  /** What undo would take back and redo do again, as the start of a sentence; null where there is nothing. */
  undoes: string | null = $state(null);
  redoes: string | null = $state(null);
  /** Whether the lab can compute: not yet where the page opens in a lab that needs more than the page itself. */
  ready = $state(true);
  readonly loader = new LabLoader();
  /** Counts runs of scenarios that replaced the whole scene (preset, link): the camera then fits again. */
  opened = $state(0);
  readonly #keeper = new Keeper();
  #history: History<Entry<S>>;
  /** How often in a row the engine broke. */
  #traps = 0;
  /** The last scene of each family one has been in. */
  #left: Record<string, S> = {};
  #pendingWhat: string | null = "Ready";
  #pendingFit = false;
  /** What came from outside while a drag was going on; it waits until that ends. */
  #waiting: (() => void) | null = null;

  constructor(scenario: S, labs: readonly Lab[]) {
    this.labs = labs;
    this.#history = new History({ scenario, what: "Opened" });
    this.scenario = scenario;
    this.lab = labOf(scenario, labs) ?? labs[0];
    this.ready = this.loader.has(this.lab);
    if (this.ready) this.#compute();
    else this.#loadShown();
  }

  /** Whether an edit is in progress. */
  get previewing(): boolean {
    return this.#history.inGesture;
  }

  /** Shows an edit in progress; `commit` makes it one entry of the history. */
  preview(what: string, next: S): void {
    this.#history.preview({ scenario: next, what });
    this.#show();
  }

  /** Ends the edit in progress. An edit that leaves a bad scenario is taken back, with the reason. */
  commit(): boolean {
    const accepted = this.#settle();
    this.#openWaiting();
    return accepted;
  }

  /** Takes the edit in progress back. */
  cancel(): void {
    this.#history.cancel();
    this.#show();
    this.#openWaiting();
  }

  /** One edit, or the last state of the one in progress. */
  edit(what: string, next: S): boolean {
    this.#history.preview({ scenario: next, what });
    return this.commit();
  }

  /** An edit that replaces the scene as a whole. */
  open(what: string, next: S): boolean {
    this.selected = [];
    const accepted = this.edit(what, next);
    this.#pendingFit ||= accepted;
    return accepted;
  }

  /** Opens one of the lab's own scenarios. */
  openPreset(name: string): boolean {
    const entry = this.lab.presets().find((candidate) => candidate.name === name);
    if (!entry) return false;
    const scenario = forLab(this.lab.preset(name), this.lab, this.labs) as S;
    return this.open(`Preset “${entry.title}” opened`, scenario);
  }

  /** Goes to another lab: with the scene, where it can show that; else to the one left there or its first preset. */
  openLab(lab: Lab): void {
    this.#withLab(lab, () => this.#openLab(lab));
  }

  #openLab(lab: Lab): void {
    this.#left[this.lab.family.name] = this.scenario;
    const kept = lab.family === this.lab.family;
    const left = this.#left[lab.family.name];
    const scenario = kept ? this.scenario : (left ?? (lab.preset(lab.firstPreset) as S));
    this.open(`Lab ${lab.title} opened`, forLab(scenario, lab, this.labs));
  }

  /** Opens the scenario of a link; a bad one is told in a sentence, leaves the address and changes nothing. */
  openLink(hash: string): Promise<void> {
    return this.#openFrom("the link", () => readLink(hash, this.labs));
  }

  /** Opens a scenario that stands elsewhere on the page. */
  openDocument(document: unknown, source: string): Promise<void> {
    return this.#openFrom(source, () => readDocument(document, startOf(source), this.labs));
  }

  /** Opens the scenario of a JSON file. */
  openFile(file: File): Promise<void> {
    return this.#openFrom(`the file ${file.name}`, async () =>
      readText(await textOf(file), `The file ${file.name}`, this.labs),
    );
  }

  /** Back to what opens without a link. */
  startFresh(): boolean {
    return this.openPreset(this.lab.firstPreset);
  }

  /** An edit in progress ends first; one that leaves a bad scenario is all that is taken back. */
  undo(): void {
    if (this.previewing && !this.#settle()) return this.#openWaiting();
    const undone = this.#history.undo();
    if (undone) this.#travel(`Undone: ${lowerFirst(undone.what)}`);
  }

  redo(): void {
    if (this.previewing && !this.#settle()) return this.#openWaiting();
    const redone = this.#history.redo();
    if (redone) this.#travel(`Done again: ${lowerFirst(redone.what)}`);
  }

  async #openFrom(source: string, read: () => Promise<SceneDocument>): Promise<void> {
    try {
      const scenario = await read();
      const lab = labOf(scenario, this.labs) ?? this.lab;
      this.#withLab(lab, () => this.open(`Scenario opened from ${source}`, scenario as S));
    } catch (error) {
      this.#afterGesture(() => this.refuse(`${sentenceOf(error)} The scene stays as it was.`));
    }
  }

  /** Does something that the lab must be there for, after a drag that goes on; a lab that cannot be had is told. */
  #withLab(lab: Lab, open: () => void): void {
    this.loader.whenThere(
      lab,
      () => this.#afterGesture(open),
      (error) =>
        this.#afterGesture(() => this.refuse(`${notLoaded(lab, error)} The lab ${this.lab.title} stays.`)),
    );
  }

  /** The lab of the scenario shown, where the page opens in it; if it cannot be had, the page opens as without a link. */
  #loadShown(): void {
    const { lab } = this;
    const standIn = (error: unknown) => {
      // Undo led back to a lab that never came: where it led from stands yet.
      if (this.#history.redo()) {
        this.#show();
        return this.refuse(`${notLoaded(lab, error)} The lab ${this.lab.title} stays.`);
      }
      const [first] = this.labs;
      this.#history = new History({ scenario: first.preset(first.firstPreset) as S, what: "Opened" });
      this.#show();
      // The address stays: the page can be loaded anew from it.
      this.refusal = `${notLoaded(lab, error)} The default scene is shown instead; reload the page to try again.`;
    };
    this.loader.whenThere(
      lab,
      () => this.#show(),
      (error) => this.#afterGesture(() => standIn(error)),
    );
  }

  /** Says why something from outside was not taken, and lets the address name the scene that is shown. */
  refuse(sentence: string): void {
    this.refusal = sentence;
    this.#keeper.shown(this.scenario);
  }

  #afterGesture(open: () => void): void {
    this.#waiting = open;
    if (!this.#history.inGesture) this.#openWaiting();
  }

  #openWaiting(): void {
    const open = this.#waiting;
    this.#waiting = null;
    open?.();
  }

  #settle(): boolean {
    const problem = this.#problem();
    if (problem) {
      this.#history.cancel();
      this.#show();
      this.refusal = `${problem.message}. The scenario stays as it was.`;
      return false;
    }
    this.refusal = null;
    this.#history.commit();
    this.#show();
    this.#announce(this.#history.present.what);
    return true;
  }

  /** What is wrong with the scenario; an engine that breaks over the question is asked again by the next run. */
  #problem(): engine.Complaint | undefined {
    try {
      const { scenario } = this.#history.present;
      return (labOf(scenario, this.labs) ?? this.lab).family.validate(scenario)[0];
    } catch (error) {
      void this.#recover(error);
      return undefined;
    }
  }

  #travel(what: string): void {
    this.refusal = null;
    this.#show();
    this.#announce(what);
    this.#openWaiting();
  }

  #show(): void {
    this.scenario = this.#history.present.scenario;
    const lab = labOf(this.scenario, this.labs) ?? this.lab;
    // A run means nothing to another lab than its own.
    if (lab !== this.lab) {
      this.run = null;
      this.lab.leave?.();
    }
    this.lab = lab;
    this.selected = existing(this, this.selected);
    this.ready = this.loader.has(lab);
    this.undoes = this.#history.canUndo ? this.#history.present.what : null;
    this.redoes = this.#history.next?.what ?? null;
    if (this.ready) scheduleCompute(this.#compute);
    else this.#loadShown();
  }

  #announce(what: string): void {
    this.#pendingWhat = what;
    this.restored = false;
    this.#keeper.edited(this.scenario);
  }

  #compute = (): void => {
    if (!this.ready) return;
    try {
      this.run = this.lab.compute(this.scenario) as R;
      this.failure = null;
      this.computed = this.scenario;
      this.#traps = 0;
    } catch (error) {
      if (error instanceof engine.EngineTrap) return void this.#recover(error);
      this.failure = `${sentenceOf(error)} The last good run stays on the screen.`;
    }
    this.#tell();
  };

  /** The engine starts afresh and gets the scenario again; one that breaks over it too gets the last good one. */
  async #recover(error: unknown): Promise<void> {
    this.#traps += 1;
    reportError(error);
    if (this.#traps > MOST_TRAPS) {
      this.failure = "The engine stops at every scene. Reload the page; the scene is kept.";
      return;
    }
    // What follows waits for the task that broke to end.
    await Promise.resolve();
    if (this.#traps > 1) this.#retreat();
    scheduleCompute(this.#compute);
  }

  #retreat(): void {
    this.#history.discard();
    const { lab } = this;
    const good = this.computed ?? (forLab(lab.preset(lab.firstPreset), lab, this.labs) as S);
    if (this.#history.present.scenario !== good)
      this.#history.edit({ scenario: good, what: "Back to a scene the engine can compute" });
    this.#show();
    this.refuse("The engine stopped at that scene twice, so the last good one is shown.");
    this.#announce("Back to the last good scene");
  }

  /** Says what changed, once the run is there that it led to. */
  #tell(): void {
    if (this.#pendingFit) this.opened += 1;
    this.#pendingFit = false;
    if (this.#pendingWhat === null) return;
    this.announcement = `${this.#pendingWhat}.`;
    this.#pendingWhat = null;
  }
}
