import { beforeEach, describe, expect, test, vi } from "vitest";
import type { FigureOrder, FigurePicture } from "../figure";
import type { FigureJob, Sums } from "../workers/messages";
import type { PoolListener } from "../workers/pool";
import { FigureRun, type FigureTools } from "./figure-run.svelte";

const A: FigureOrder = { name: "a", trials: 80, seed: 1 };

/** Workers whose answers the test gives, and a sum that remembers in which order it was given them. */
class Fake implements FigureTools {
  listener!: PoolListener<FigureJob, Sums>;
  queue: FigureJob[] = [];
  open = 0;
  pushed: number[] = [];

  openPool(listener: PoolListener<FigureJob, Sums>) {
    this.listener = listener;
    return {
      replace: (jobs: readonly FigureJob[]) => void (this.queue = [...jobs]),
      close: () => void (this.queue = []),
    };
  }
  jobs({ trials }: FigureOrder): number {
    if (trials === 0) throw new Error("0 trials are too few.");
    return trials / 20;
  }
  openSum(order: FigureOrder) {
    this.open += 1;
    const pushed = (this.pushed = []) as number[];
    return {
      push: (block: Float64Array) => {
        if (Number.isNaN(block[0])) throw new Error("The engine stopped.");
        pushed.push(block[0]);
      },
      // Two curves: the first has a trial after one job, both after two.
      read: () =>
        ({ report: { name: order.name, trials: 20 * (pushed.length >> 1) }, json: "{}" }) as FigurePicture,
      csv: () => `${pushed.length} jobs`,
      free: () => void (this.open -= 1),
    };
  }
  /** The next `count` jobs come, the last one first. */
  answer(count: number, value?: number): void {
    for (const job of this.queue.splice(0, count).reverse())
      this.listener.done(job, Float64Array.of(value ?? job.job));
  }
}

function start(): [Fake, FigureRun] {
  const fake = new Fake();
  return [fake, new FigureRun(fake)];
}

beforeEach(() => {
  vi.useFakeTimers();
  return () => vi.useRealTimers();
});

describe("a figure under way", () => {
  test("joins jobs in order, draws what every curve has trials of, and ends with its table", () => {
    const [fake, run] = start();
    run.start(A);
    expect([run.jobs, run.done, run.running]).toEqual([4, 0, true]);
    fake.answer(1);
    expect(run.picture).toBeNull();
    vi.advanceTimersByTime(1000);
    fake.answer(1);
    expect(run.picture?.report.trials).toBe(20);
    expect(run.secondsLeft).toBeCloseTo(1);
    expect(run.complete).toBe(false);
    fake.answer(2);
    expect(fake.pushed).toEqual([0, 1, 2, 3]);
    expect([run.done, run.running, run.complete, run.csv]).toEqual([4, false, true, "4 jobs"]);
    expect(run.picture?.report.trials).toBe(40);
    expect(fake.open).toBe(0);
  });

  test("shows at the end of a cancelled one what is there, and files of complete ones only", () => {
    const [fake, run] = start();
    run.start(A);
    fake.answer(3);
    run.cancel();
    expect([run.running, run.cancelled, run.complete]).toEqual([false, true, false]);
    expect(run.picture?.report.trials).toBe(20);
    expect([fake.queue.length, fake.open]).toEqual([0, 0]);
    fake.listener.done({ order: A, job: 3 }, Float64Array.of(3));
    expect(run.done).toBe(3);
  });

  test("is of an earlier order until the first drawing of the new one, not only until its first job", () => {
    const [fake, run] = start();
    run.start(A);
    fake.answer(2);
    expect(run.stale).toBe(false);
    run.start({ ...A, seed: 2 });
    fake.answer(1);
    expect([run.done, run.stale]).toEqual([1, true]);
    vi.advanceTimersByTime(1000);
    fake.answer(1);
    expect(run.stale).toBe(false);
    fake.answer(2);
    expect([run.complete, run.stale]).toEqual([true, false]);
  });

  test("keeps the last good figure where the next one cannot be, and says why", () => {
    const [fake, run] = start();
    run.start(A);
    fake.answer(4);
    run.start({ ...A, trials: 0 });
    expect(run.failure).toBe("0 trials are too few. The figure stays as it was.");
    expect([run.order?.trials, run.jobs]).toEqual([0, 0]);
    expect(run.picture?.report.trials).toBe(40);
    expect(run.complete).toBe(true);
    run.start(A);
    expect(run.failure).toBeNull();
    fake.answer(1, NaN);
    expect(run.failure).toContain("The engine stopped.");
    expect([run.running, fake.open]).toEqual([false, 0]);
    run.start(A);
    fake.listener.failed("The workers stopped 6 times in a row.", false);
    expect(run.failure).toContain("6 times");
  });
});
