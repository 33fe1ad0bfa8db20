import type { StudyCurves } from "../study";
import type { Scenario } from "../scenario";
import { InOrder } from "../workers/in-order";
import type { Block, Sums } from "../workers/messages";
import type { PoolListener } from "../workers/pool";

export const TRIALS_PER_BLOCK = 20;
/** A picture of fewer trials is shown only where there is none, or where these take too long. */
export const FIRST_PICTURE = 200;
/** Enough that the bands are thin; then the workers rest. */
export const MOST_TRIALS = 2000;
/** A first picture that takes longer than this is not waited for. */
const PATIENCE_MS = 1500;
/** A growing study is drawn anew this often. */
const REFRESH_MS = 250;

/** Averages over trials, and what they are averages of. */
export interface StudyPicture {
  readonly scenario: Scenario;
  readonly times: Float64Array;
  readonly curves: StudyCurves;
}

/** What the study needs from the engine and the workers. */
export interface StudyTools {
  openPool(listener: PoolListener<Block, Sums>): PoolLike;
  openSum(scenario: Scenario): SumLike;
}
interface PoolLike {
  replace(blocks: readonly Block[]): void;
  hold(): void;
  proceed(): void;
  close(): void;
}
interface SumLike {
  push(block: Float64Array): void;
  read(): StudyCurves;
  free(): void;
}

/** One scenario's trials under way. */
interface Round {
  readonly scenario: Scenario;
  readonly key: string;
  readonly times: Float64Array;
  readonly sum: SumLike;
  readonly order: InOrder<Float64Array>;
  /** When it began; later by the time it was stopped for. */
  started: number;
}

/** The Monte-Carlo study of the scenario at hand: the same trials 0, 1, 2, … whatever is changed. */
export class Study {
  /** The latest picture; it stays until the next one is there. */
  picture: StudyPicture | null = $state.raw(null);
  /** Whether the picture is of an earlier scenario. */
  stale = $state(false);
  /** Trials counted of the scenario at hand. */
  trials = $state(0);
  stopped = $state(false);
  secondsLeft: number | null = $state(null);
  failure: string | null = $state(null);
  readonly #pool: PoolLike;
  #wanted: Pick<Round, "scenario" | "key" | "times"> | null = null;
  #round: Round | null = null;
  #pictureKey: string | null = null;
  #shownAt = -Infinity;
  #stoppedAt = 0;

  constructor(private readonly tools: StudyTools) {
    this.#pool = tools.openPool({
      done: (block, sums) => this.#guard(() => this.#merge(block, sums)),
      failed: (sentence) => this.#fail(sentence),
    });
  }

  get running(): boolean {
    return !this.stopped && this.failure === null && this.trials < MOST_TRIALS;
  }

  /**
   * The scenario to study now. While it is being dragged, the first picture of the one before is finished where that
   * is a matter of a moment: else there would be none until the pointer rests.
   */
  follow(scenario: Scenario, times: Float64Array, dragged: boolean): void {
    const key = JSON.stringify({ ...scenario, name: "", view: null });
    this.#wanted = { scenario, key, times };
    this.stale = this.#pictureKey !== null && this.#pictureKey !== key;
    if (this.#round?.key === key && this.failure === null) return;
    if (this.stopped || (dragged && this.#almostThere())) return;
    this.#begin();
  }

  stop(): void {
    this.stopped = true;
    this.#stoppedAt = performance.now();
    this.secondsLeft = null;
    this.#pool.hold();
  }

  proceed(): void {
    if (this.#round && this.stopped) this.#round.started += performance.now() - this.#stoppedAt;
    this.stopped = false;
    this.#pool.proceed();
    if (this.failure !== null || this.#wanted?.key !== this.#round?.key) this.#begin();
  }

  close(): void {
    this.#pool.close();
    this.#round?.sum.free();
  }

  #almostThere(): boolean {
    if (!this.#round || this.trials >= FIRST_PICTURE) return false;
    return performance.now() - this.#round.started < PATIENCE_MS;
  }

  #begin(): void {
    if (!this.#wanted) return;
    const wanted = this.#wanted;
    this.#round?.sum.free();
    this.#round = null;
    this.trials = 0;
    this.secondsLeft = null;
    this.failure = null;
    this.#guard(() => {
      const sum = this.tools.openSum(wanted.scenario);
      this.#round = { ...wanted, sum, order: new InOrder(), started: performance.now() };
      this.#pool.replace(blocksOf(wanted.scenario));
    });
  }

  #merge(block: Block, sums: Float64Array): void {
    const round = this.#round;
    if (!round) return;
    for (const ready of round.order.accept(block.firstTrial / TRIALS_PER_BLOCK, sums)) {
      round.sum.push(ready);
      this.trials += TRIALS_PER_BLOCK;
    }
    const elapsed = performance.now() - round.started;
    if (this.#due(round, elapsed)) this.#show(round, elapsed);
    if (this.trials >= FIRST_PICTURE && this.#wanted?.key !== round.key && !this.stopped) this.#begin();
  }

  #due(round: Round, elapsed: number): boolean {
    if (this.trials === 0) return false;
    const begun = this.#pictureKey === null || this.#pictureKey === round.key;
    if (!begun && this.trials < FIRST_PICTURE && elapsed < PATIENCE_MS) return false;
    const shown = begun ? (this.picture?.curves.trials ?? 0) : 0;
    if (shown < FIRST_PICTURE && this.trials >= FIRST_PICTURE) return true;
    // After a stop only the blocks begun still come: none of them is kept back.
    if (!begun || this.stopped || this.trials === MOST_TRIALS) return true;
    return performance.now() - this.#shownAt > REFRESH_MS;
  }

  #show(round: Round, elapsed: number): void {
    this.#shownAt = performance.now();
    this.#pictureKey = round.key;
    this.picture = { scenario: round.scenario, times: round.times, curves: round.sum.read() };
    this.stale = this.#wanted?.key !== round.key;
    this.secondsLeft = ((MOST_TRIALS - this.trials) * elapsed) / this.trials / 1000;
  }

  /** An engine that trapped says so in a sentence; the page goes on. */
  #guard(work: () => void): void {
    try {
      work();
    } catch (error) {
      this.#pool.replace([]);
      this.#fail(error instanceof Error ? error.message : String(error));
    }
  }

  #fail(sentence: string): void {
    this.failure = `${sentence} The averages stay as they were.`;
    this.secondsLeft = null;
  }
}

function blocksOf(scenario: Scenario): Block[] {
  return Array.from({ length: MOST_TRIALS / TRIALS_PER_BLOCK }, (_, index) => ({
    scenario,
    firstTrial: index * TRIALS_PER_BLOCK,
    trials: TRIALS_PER_BLOCK,
  }));
}
