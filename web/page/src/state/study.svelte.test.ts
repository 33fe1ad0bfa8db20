import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import type { StudyCurves } from "../study";
import type { Scenario } from "../scenario";
import type { Block, Sums } from "../workers/messages";
import type { PoolListener } from "../workers/pool";
import { FIRST_PICTURE, MOST_TRIALS, Study, type StudyTools, TRIALS_PER_BLOCK } from "./study.svelte";

const scenario = (name: string) => ({ name, seed: name.length, view: null }) as unknown as Scenario;
const A = scenario("a");
const B = scenario("bb");
const C = scenario("ccc");
const TIMES = Float64Array.of(0.1);

/** Workers whose answers the test gives, and a sum that remembers in which order it was given them. */
class Fake implements StudyTools {
  listener!: PoolListener<Block, Sums>;
  queue: Block[] = [];
  held = false;
  open = 0;

  openPool(listener: PoolListener<Block, Sums>) {
    this.listener = listener;
    return {
      replace: (blocks: readonly Block[]) => void (this.queue = [...blocks]),
      hold: () => void (this.held = true),
      proceed: () => void (this.held = false),
      close: () => void (this.queue = []),
    };
  }
  openSum() {
    this.open += 1;
    const pushed: number[] = [];
    return {
      push: (block: Float64Array) => {
        if (Number.isNaN(block[0])) throw new Error("The engine stopped.");
        pushed.push(block[0]);
      },
      read: () => ({ trials: pushed.length * TRIALS_PER_BLOCK, pushed }) as unknown as StudyCurves,
      free: () => void (this.open -= 1),
    };
  }
  /** The next `count` blocks come, the last one first. */
  answer(count: number): void {
    const blocks = this.queue.splice(0, count).reverse();
    for (const block of blocks) this.listener.done(block, Float64Array.of(block.firstTrial));
  }
}

const shown = (study: Study) => study.picture?.curves as unknown as { trials: number; pushed: number[] };

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

describe("the study", () => {
  test("shows something at once, counts trials in order and rests at the end", () => {
    const [fake, study] = start();
    study.follow(A, TIMES, false);
    fake.answer(1);
    expect(shown(study).trials).toBe(TRIALS_PER_BLOCK);
    vi.advanceTimersByTime(1000);
    while (fake.queue.length > 0) fake.answer(7);
    expect(shown(study).trials).toBe(MOST_TRIALS);
    expect(shown(study).pushed).toEqual(shown(study).pushed.toSorted((a, b) => a - b));
    expect([study.running, study.secondsLeft, study.stale]).toEqual([false, 0, false]);
  });

  test("keeps the old picture, marked, until the new one is complete", () => {
    const [fake, study] = start();
    complete(fake, study, A);
    study.follow(B, TIMES, false);
    expect([study.stale, study.trials]).toEqual([true, 0]);
    fake.answer(FIRST_PICTURE / TRIALS_PER_BLOCK - 1);
    expect([study.picture?.scenario, study.stale]).toEqual([A, true]);
    fake.answer(1);
    expect([study.picture?.scenario, study.stale]).toEqual([B, false]);
    expect(shown(study).trials).toBe(FIRST_PICTURE);
  });

  test("while one drags, finishes the first picture begun and goes on with the latest scenario", () => {
    const [fake, study] = start();
    complete(fake, study, A);
    study.follow(B, TIMES, true);
    fake.answer(3);
    study.follow(scenario("between"), TIMES, true);
    study.follow(C, TIMES, true);
    expect(fake.queue[0].scenario).toBe(B);
    fake.answer(FIRST_PICTURE / TRIALS_PER_BLOCK - 3);
    expect([study.picture?.scenario, study.stale]).toEqual([B, true]);
    expect(fake.queue[0].scenario).toBe(C);
  });

  test("drops the old work where nobody drags, where it is slow, and where it has given its picture", () => {
    const [fake, study] = start();
    study.follow(A, TIMES, true);
    fake.answer(3);
    study.follow(B, TIMES, false);
    expect(fake.queue[0].scenario).toBe(B);
    vi.advanceTimersByTime(2000);
    study.follow(C, TIMES, true);
    expect(fake.queue[0].scenario).toBe(C);
    fake.answer(FIRST_PICTURE / TRIALS_PER_BLOCK);
    study.follow(A, TIMES, true);
    expect(fake.queue[0].scenario).toBe(A);
  });

  test("a name or a camera is no other scenario", () => {
    const [fake, study] = start();
    study.follow(A, TIMES, false);
    fake.answer(2);
    study.follow({ ...A, name: "renamed", view: { camera: 1 } }, TIMES, false);
    expect([study.trials, study.stale]).toEqual([2 * TRIALS_PER_BLOCK, false]);
  });

  test("stops and goes on where it was; what was changed meanwhile is studied then", () => {
    const [fake, study] = start();
    study.follow(A, TIMES, false);
    fake.answer(2);
    study.stop();
    expect([fake.held, study.running]).toEqual([true, false]);
    study.proceed();
    expect([fake.held, study.trials]).toEqual([false, 2 * TRIALS_PER_BLOCK]);
    study.stop();
    study.follow(B, TIMES, false);
    expect([fake.queue[0].scenario, study.stale]).toEqual([A, true]);
    study.proceed();
    expect([fake.queue[0].scenario, study.trials]).toEqual([B, 0]);
  });

  test("says why it cannot go on, keeps the picture, and tries again when asked", () => {
    const [fake, study] = start();
    complete(fake, study, A);
    fake.listener.done(fake.queue[0], Float64Array.of(NaN));
    expect(study.failure).toBe("The engine stopped. The averages stay as they were.");
    expect(study.picture?.scenario).toBe(A);
    study.proceed();
    expect([study.failure, fake.queue.length]).toEqual([null, MOST_TRIALS / TRIALS_PER_BLOCK]);
  });

  test("frees every sum it opened", () => {
    const [fake, study] = start();
    for (const next of [A, B, C]) study.follow(next, TIMES, false);
    expect(fake.open).toBe(1);
    study.close();
    expect(fake.open).toBe(0);
  });
});

function start(): [Fake, Study] {
  const fake = new Fake();
  return [fake, new Study(fake)];
}

function complete(fake: Fake, study: Study, of: Scenario): void {
  study.follow(of, TIMES, false);
  fake.answer(1);
  vi.advanceTimersByTime(300);
  fake.answer(FIRST_PICTURE / TRIALS_PER_BLOCK - 1);
  expect(shown(study).trials).toBe(FIRST_PICTURE);
}
