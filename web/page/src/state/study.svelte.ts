import { EngineRestarted } from "../engine";
import type { SceneDocument } from "../family";
import { InOrder } from "../workers/in-order";
import type { Block, Sums } from "../workers/messages";
import type { PoolListener } from "../workers/pool";

/** A first picture that takes longer than this is not waited for. */
const PATIENCE_MS = 1500;
/** A growing study is drawn anew this often. */
const REFRESH_MS = 250;

/** How many trials a study takes, and in what portions. */
export interface StudyPlan {
  readonly perBlock: number;
  /** A picture of fewer trials is shown only where there is none, or where these take too long. */
  readonly firstPicture: number;
  /** Enough that the bands are thin; then the workers rest. */
  readonly most: number;
}

/** What is known after so many trials. */
export interface Averages {
  readonly trials: number;
}

/** What a study is of. */
export interface StudySubject<A extends Averages = Averages, S extends SceneDocument = SceneDocument> {
  readonly scenario: S;
  /** The same key, the same numbers. */
  readonly key: string;
  readonly plan: StudyPlan;
  /** A coarser study of the same, soon done: for scenarios that a drag leaves behind. Without one the study itself. */
  readonly sketch?: StudySubject<A, S>;
  block(firstTrial: number, trials: number): Block;
  openSum(): SumLike<A>;
}

/** Averages over trials, and what they are averages of. */
export interface StudyPicture<A extends Averages = Averages, S extends SceneDocument = SceneDocument> {
  readonly scenario: S;
  readonly averages: A;
}

/** Gives the study its workers. */
export type OpenPool = (listener: PoolListener<Block, Sums>) => PoolLike;
export interface PoolLike {
  replace(blocks: readonly Block[]): void;
  hold(): void;
  proceed(): void;
  close(): void;
}
export interface SumLike<A extends Averages = Averages> {
  push(block: Float64Array): void;
  read(): A;
  free(): void;
}

/** One subject's trials under way. */
interface Round {
  readonly subject: StudySubject;
  readonly sum: SumLike;
  readonly order: InOrder<Float64Array>;
  /** When it began; later by the time it was stopped for. */
  started: number;
}

/** What trials are averaged over changes from one scenario to the next, their names do not. */
export function keyOf(scenario: object): string {
  return JSON.stringify({ ...scenario, name: "", view: null });
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
  /** Of the subject at hand; null before the first one. */
  plan: StudyPlan | null = $state.raw(null);
  readonly #pool: PoolLike;
  #wanted: StudySubject | null = null;
  #round: Round | null = null;
  #pictureKey: string | null = null;
  #shownAt = -Infinity;
  #stoppedAt = 0;

  constructor(openPool: OpenPool) {
    this.#pool = openPool({
      done: (block, sums) => this.#guard(() => this.#merge(block, sums)),
      failed: (sentence) => this.#fail(sentence),
    });
  }

  get running(): boolean {
    return !this.stopped && this.failure === null && this.trials < (this.plan?.most ?? Infinity);
  }

  /**
   * What to study now. While it is being dragged, its sketch; and the first picture of the one before is finished where
   * that is a matter of a moment: else there would be none until the pointer rests.
   */
  follow(subject: StudySubject, dragged: boolean): void {
    const sketched = dragged && this.#round?.subject.key !== subject.key;
    const wanted = sketched ? (subject.sketch ?? subject) : subject;
    this.#wanted = wanted;
    this.stale = this.#pictureKey !== null && this.#pictureKey !== wanted.key;
    if (this.#round?.subject.key === wanted.key && this.failure === null) return;
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
    if (this.failure !== null || this.#wanted?.key !== this.#round?.subject.key) this.#begin();
  }

  close(): void {
    this.#pool.close();
    this.#round?.sum.free();
  }

  #almostThere(): boolean {
    if (!this.#round || this.trials >= this.#round.subject.plan.firstPicture) return false;
    return performance.now() - this.#round.started < PATIENCE_MS;
  }

  #begin(): void {
    if (!this.#wanted) return;
    const subject = this.#wanted;
    this.#round?.sum.free();
    this.#round = null;
    this.trials = 0;
    this.secondsLeft = null;
    this.failure = null;
    this.plan = subject.plan;
    this.#guard(() => {
      const sum = subject.openSum();
      this.#round = { subject, sum, order: new InOrder(), started: performance.now() };
      this.#pool.replace(blocksOf(subject));
    });
  }

  #merge(block: Block, sums: Float64Array): void {
    const round = this.#round;
    if (!round) return;
    const { key, plan } = round.subject;
    for (const ready of round.order.accept(block.firstTrial / plan.perBlock, sums)) {
      round.sum.push(ready);
      this.trials += plan.perBlock;
    }
    const elapsed = performance.now() - round.started;
    if (this.#due(round, elapsed)) this.#show(round, elapsed);
    if (this.trials >= plan.firstPicture && this.#wanted?.key !== key && !this.stopped) this.#begin();
  }

  #due({ subject }: Round, elapsed: number): boolean {
    if (this.trials === 0) return false;
    const { firstPicture, most } = subject.plan;
    const begun = this.#pictureKey === null || this.#pictureKey === subject.key;
    if (!begun && this.trials < firstPicture && elapsed < PATIENCE_MS) return false;
    const shown = begun ? (this.picture?.averages.trials ?? 0) : 0;
    if (shown < firstPicture && this.trials >= firstPicture) return true;
    // After a stop only the blocks begun still come: none of them is kept back.
    if (!begun || this.stopped || this.trials === most) return true;
    return performance.now() - this.#shownAt > REFRESH_MS;
  }

  #show({ subject, sum }: Round, elapsed: number): void {
    this.#shownAt = performance.now();
    this.#pictureKey = subject.key;
    this.picture = { scenario: subject.scenario, averages: sum.read() };
    this.stale = this.#wanted?.key !== subject.key;
    this.secondsLeft = ((subject.plan.most - this.trials) * elapsed) / this.trials / 1000;
  }

  /** An engine that trapped says so in a sentence; one that was started again meanwhile counts from the first trial. */
  #guard(work: () => void): void {
    try {
      work();
    } catch (error) {
      if (error instanceof EngineRestarted) return this.#begin();
      this.#pool.replace([]);
      this.#fail(error instanceof Error ? error.message : String(error));
    }
  }

  #fail(sentence: string): void {
    this.failure = `${sentence} The averages stay as they were.`;
    this.secondsLeft = null;
  }
}

function blocksOf(subject: StudySubject): Block[] {
  const { perBlock, most } = subject.plan;
  return Array.from({ length: most / perBlock }, (_, index) => subject.block(index * perBlock, perBlock));
}
