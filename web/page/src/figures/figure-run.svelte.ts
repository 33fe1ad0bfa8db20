import type { FigureOrder, FigurePicture } from "../figure";
import { InOrder } from "../workers/in-order";
import type { FigureJob, Sums } from "../workers/messages";
import type { PoolListener } from "../workers/pool";

/** A growing figure is drawn anew after this, or after so many times what drawing it took. */
const REFRESH_MS = 400;
const REFRESH_FACTOR = 8;

/** What the figure needs from the engine and the workers. */
export interface FigureTools {
  openPool(listener: PoolListener<FigureJob, Sums>): {
    replace(jobs: readonly FigureJob[]): void;
    close(): void;
  };
  openSum(order: FigureOrder): SumLike;
  /** How many jobs there are; throws a sentence where there can be none. */
  jobs(order: FigureOrder): number;
}
interface SumLike {
  push(block: Float64Array): void;
  read(): FigurePicture;
  csv(): string;
  free(): void;
}

/** One figure under way. */
interface Round {
  readonly order: FigureOrder;
  readonly sum: SumLike;
  readonly early: InOrder<Float64Array>;
  readonly started: number;
}

/** A figure computed in workers: it grows, can be cancelled, and what was good stays. */
export class FigureRun {
  /** The latest picture; it stays until the next one is there. */
  picture: FigurePicture | null = $state.raw(null);
  /** What the picture was asked for by. */
  #drawn: FigureOrder | null = $state.raw(null);
  /** The table of a finished figure, as the command line writes it. */
  csv: string | null = $state.raw(null);
  /** What is computed, or was last, or was refused. */
  order: FigureOrder | null = $state.raw(null);
  jobs = $state(0);
  done = $state(0);
  running = $state(false);
  cancelled = $state(false);
  secondsLeft: number | null = $state(null);
  failure: string | null = $state(null);
  readonly #pool: ReturnType<FigureTools["openPool"]>;
  #round: Round | null = null;
  #nextDrawing = 0;

  constructor(private readonly tools: FigureTools) {
    this.#pool = tools.openPool({
      done: (job, sums) => this.#guard(() => this.#join(job, sums)),
      failed: (sentence) => this.#fail(sentence),
    });
  }

  /** Whether the picture is of all its trials: then files can be made of it. */
  get complete(): boolean {
    return this.csv !== null && !this.running;
  }

  /** Whether the picture is of an earlier order than the one under way. */
  get stale(): boolean {
    return this.running && this.#drawn !== this.order;
  }

  start(order: FigureOrder): void {
    this.#end();
    [this.order, this.jobs, this.done] = [order, 0, 0];
    [this.cancelled, this.failure] = [false, null];
    this.#guard(() => {
      const jobs = this.tools.jobs(order);
      this.#round = {
        order,
        sum: this.tools.openSum(order),
        early: new InOrder(),
        started: performance.now(),
      };
      [this.jobs, this.running] = [jobs, true];
      this.#nextDrawing = 0;
      this.#pool.replace(Array.from({ length: jobs }, (_, job) => ({ order, job })));
    });
  }

  /** Ends it; the part that is there stays to be looked at. */
  cancel(): void {
    if (!this.running) return;
    this.cancelled = true;
    this.#guard(() => this.#draw());
    this.#end();
  }

  close(): void {
    this.#end();
    this.#pool.close();
  }

  #join({ job }: FigureJob, sums: Float64Array): void {
    const round = this.#round;
    if (!round) return;
    for (const ready of round.early.accept(job, sums)) {
      round.sum.push(ready);
      this.done += 1;
    }
    const now = performance.now();
    if (this.done > 0)
      this.secondsLeft = ((now - round.started) / this.done / 1000) * (this.jobs - this.done);
    if (this.done === this.jobs) {
      this.#draw();
      this.csv = round.sum.csv();
      this.#end();
    } else if (now >= this.#nextDrawing) this.#draw();
  }

  #draw(): void {
    const began = performance.now();
    const picture = this.#round?.sum.read();
    // Until every curve has a trial there is nothing to see.
    if (!picture || picture.report.trials === 0) return;
    this.picture = picture;
    this.#drawn = this.order;
    this.csv = null;
    const took = performance.now() - began;
    this.#nextDrawing = performance.now() + Math.max(REFRESH_MS, REFRESH_FACTOR * took);
  }

  #end(): void {
    this.#pool.replace([]);
    this.#round?.sum.free();
    this.#round = null;
    this.running = false;
    this.secondsLeft = null;
  }

  #guard(work: () => void): void {
    try {
      work();
    } catch (error) {
      this.#fail(error instanceof Error ? error.message : String(error));
    }
  }

  #fail(sentence: string): void {
    this.#end();
    this.failure = `${sentence}${this.picture ? " The figure stays as it was." : ""}`;
  }
}
