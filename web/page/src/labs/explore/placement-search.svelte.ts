import type { Improvement } from "../../generated/Improvement";
import type { Scenario } from "../../scenario";
import type { Search } from "../../workers/messages";
import { type PoolListener, WorkerPool } from "../../workers/pool";
import { startPlaceWorker, workerCount } from "../../workers/start";
import { formatValue } from "./placement";

interface PoolLike {
  replace(jobs: readonly Search[]): void;
  close(): void;
}
export type OpenPool = (listener: PoolListener<Search, Improvement>) => PoolLike;

/** What a search is for: the scenario as it is when it ends, and who takes the anchors found. */
export interface Seeker {
  /** Null where the page shows another kind of document. */
  current(): Scenario | null;
  /** Called at most once, with anchors that are better than those of the scenario. */
  apply(best: Improvement): void;
}

interface Round {
  readonly key: string;
  readonly wanted: number;
  readonly seeker: Seeker;
}

/** Searches for better anchors, in workers: all of them before any anchor moves. */
export class PlacementSearch {
  restarts = $state(8);
  running = $state(false);
  done = $state(0);
  /** How the last search ended, and for what. */
  #outcome = $state.raw({ sentence: "", problem: "" });
  #best: Improvement | null = $state.raw(null);
  #problem: string | null = $state.raw(null);
  #round: Round | null = null;
  #pool: PoolLike | null = null;

  constructor(private readonly open: OpenPool) {}

  /** The best found for the scenario's placement, wherever its free anchors are now. */
  bestFor(scenario: Scenario): Improvement | null {
    return this.#problem === problemOf(scenario) ? this.#best : null;
  }

  /** How the last search ended, as a sentence; empty where that was for something else. */
  outcomeFor(scenario: Scenario): string {
    const { sentence, problem } = this.#outcome;
    return sentence !== "" && problem === problemOf(scenario) ? sentence : "";
  }

  /** Searches anew; a search under way is dropped. */
  start(seeker: Seeker): void {
    const scenario = seeker.current();
    if (scenario === null) return;
    const wanted = this.restarts;
    this.#pool?.close();
    this.#round = { key: keyOf(scenario), wanted, seeker };
    this.#best = this.bestFor(scenario);
    this.#problem = problemOf(scenario);
    this.running = true;
    this.done = 0;
    this.#outcome = { sentence: "", problem: "" };
    this.#pool ??= this.open({
      done: (_, found) => this.#merge(found),
      failed: (sentence) => this.#end(sentence),
    });
    this.#pool.replace(Array.from({ length: wanted }, (_, restart) => ({ scenario, restart })));
  }

  /** Ends the search at once; no anchor has moved. */
  cancel(): void {
    if (this.running) this.#end("Cancelled: no anchor has moved.");
  }

  #merge(found: Improvement): void {
    const round = this.#round;
    if (!round) return;
    const scenario = round.seeker.current();
    if (scenario === null || keyOf(scenario) !== round.key)
      return this.#end("The scene has changed: the search was stopped.");
    this.done += 1;
    if (isBetter(found, this.#best)) this.#best = found;
    if (this.done === round.wanted) this.#finish(round, found.before);
  }

  #finish({ seeker, wanted }: Round, before: number | null): void {
    const best = this.#best;
    const better = best !== null && best.after !== null && (before === null || best.after < before);
    if (!better) return this.#end("No better places were found.");
    this.#end(`Best of ${wanted}: ${formatValue(best.after, best.unit)}.`);
    seeker.apply(best);
  }

  #end(sentence: string): void {
    this.#pool?.close();
    const scenario = this.#round?.seeker.current() ?? null;
    this.#round = null;
    this.running = false;
    this.#outcome = { sentence, problem: scenario === null ? "" : problemOf(scenario) };
  }
}

/** A tie goes to the earlier restart, so that the order in which workers answer makes no difference. */
function isBetter(found: Improvement, best: Improvement | null): boolean {
  if (found.after === null) return false;
  if (best === null || best.after === null || found.after < best.after) return true;
  return found.after === best.after && found.restart < best.restart;
}

function keyOf(scenario: Scenario): string {
  return JSON.stringify({ ...scenario, name: "", view: null });
}

/** All that decides what is best, without where the free anchors happen to be. */
function problemOf({ anchors, field, placement, ...scenario }: Scenario): string {
  const { form, headings } = field;
  const held = anchors.map((anchor, index) => (placement.fixed.includes(index) ? anchor : null));
  return keyOf({ ...scenario, redraw_anchors: null, held, form, headings, placement } as unknown as Scenario);
}

/** A search over many places of the body with many anchors takes long; who waits can cancel. */
const PATIENCE_MS = 120_000;

/** The page's one search. */
export const search = new PlacementSearch(
  (listener) => new WorkerPool(workerCount(), startPlaceWorker, listener, PATIENCE_MS),
);
