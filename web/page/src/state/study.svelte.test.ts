import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { EngineRestarted } from "../engine";
import type { Scenario } from "../scenario";
import type { Block, Sums } from "../workers/messages";
import type { PoolListener } from "../workers/pool";
import { keyOf, Study, type StudySubject } from "./study.svelte";

const scenario = (name: string) => ({ name, seed: name.length, view: null }) as unknown as Scenario;
const A = scenario("a");
const B = scenario("bb");
const C = scenario("ccc");
const [TRIALS_PER_BLOCK, FIRST_PICTURE, MOST_TRIALS] = [20, 200, 2000];
const PLAN = { perBlock: TRIALS_PER_BLOCK, firstPicture: FIRST_PICTURE, most: MOST_TRIALS };
const SKETCH = { perBlock: 10, firstPicture: 10, most: 10 };

/** Workers whose answers the test gives, and a sum that remembers in which order it was given them. */
class Fake {
  listener!: PoolListener<Block, Sums>;
  queue: Block[] = [];
  held = false;
  open = 0;
  /** Which engine it is since the last restart. */
  engine = 0;

  openPool = (listener: PoolListener<Block, Sums>) => {
    this.listener = listener;
    return {
      replace: (blocks: readonly Block[]) => void (this.queue = [...blocks]),
      hold: () => void (this.held = true),
      proceed: () => void (this.held = false),
      close: () => void (this.queue = []),
    };
  };
  subject(of: Scenario, plan = PLAN): StudySubject {
    return {
      scenario: of,
      key: keyOf(of) + plan.most,
      plan,
      block: (firstTrial, trials) => ({ scenario: of, firstTrial, trials }),
      openSum: () => this.openSum(plan.perBlock),
    };
  }
  openSum(perBlock: number) {
    this.open += 1;
    const born = this.engine;
    const pushed: number[] = [];
    return {
      push: (block: Float64Array) => {
        if (Number.isNaN(block[0])) throw new Error("The engine stopped.");
        if (born !== this.engine) throw new EngineRestarted();
        pushed.push(block[0]);
      },
      read: () => ({ trials: pushed.length * perBlock, pushed }),
      free: () => void (this.open -= 1),
    };
  }
  /** The next `count` blocks come, the last one first. */
  answer(count: number): void {
    const blocks = this.queue.splice(0, count).reverse();
    for (const block of blocks) this.listener.done(block, Float64Array.of(block.firstTrial));
  }
}

const shown = (study: Study) => study.picture?.averages as { trials: number; pushed: number[] };

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

describe("the study", () => {
  test("shows something at once, counts trials in order and rests at the end", () => {
    const [fake, study] = start();
    study.follow(fake.subject(A), false);
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
    study.follow(fake.subject(B), false);
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
    study.follow(fake.subject(B), true);
    fake.answer(3);
    study.follow(fake.subject(scenario("between")), true);
    study.follow(fake.subject(C), true);
    expect(fake.queue[0].scenario).toBe(B);
    fake.answer(FIRST_PICTURE / TRIALS_PER_BLOCK - 3);
    expect([study.picture?.scenario, study.stale]).toEqual([B, true]);
    expect(fake.queue[0].scenario).toBe(C);
  });

  test("drops the old work where nobody drags, where it is slow, and where it has given its picture", () => {
    const [fake, study] = start();
    study.follow(fake.subject(A), true);
    fake.answer(3);
    study.follow(fake.subject(B), false);
    expect(fake.queue[0].scenario).toBe(B);
    vi.advanceTimersByTime(2000);
    study.follow(fake.subject(C), true);
    expect(fake.queue[0].scenario).toBe(C);
    fake.answer(FIRST_PICTURE / TRIALS_PER_BLOCK);
    study.follow(fake.subject(A), true);
    expect(fake.queue[0].scenario).toBe(A);
  });

  test("a name or a camera is no other scenario", () => {
    const [fake, study] = start();
    study.follow(fake.subject(A), false);
    fake.answer(2);
    study.follow(fake.subject({ ...A, name: "renamed", view: { camera: 1 } }), false);
    expect([study.trials, study.stale]).toEqual([2 * TRIALS_PER_BLOCK, false]);
  });

  test("stops and goes on where it was; what was changed meanwhile is studied then", () => {
    const [fake, study] = start();
    study.follow(fake.subject(A), false);
    fake.answer(2);
    study.stop();
    expect([fake.held, study.running]).toEqual([true, false]);
    study.proceed();
    expect([fake.held, study.trials]).toEqual([false, 2 * TRIALS_PER_BLOCK]);
    study.stop();
    study.follow(fake.subject(B), false);
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

  test("begins anew where the engine was started again meanwhile", () => {
    const [fake, study] = start();
    study.follow(fake.subject(A), false);
    fake.answer(3);
    fake.engine += 1;
    fake.answer(1);
    expect([study.failure, study.trials, fake.queue[0].firstTrial, fake.open]).toEqual([null, 0, 0, 1]);
    fake.answer(FIRST_PICTURE / TRIALS_PER_BLOCK);
    expect(shown(study).trials).toBe(FIRST_PICTURE);
  });

  test("what is dragged is sketched first, what the picture is of already is not", () => {
    const [fake, study] = start();
    const dragged = (of: Scenario) => ({ ...fake.subject(of), sketch: fake.subject(of, SKETCH) });
    study.follow(dragged(A), false);
    study.follow(dragged(A), true);
    expect(fake.queue[0].trials).toBe(TRIALS_PER_BLOCK);
    complete(fake, study, A);
    study.follow(dragged(B), true);
    expect([fake.queue.length, fake.queue[0].trials]).toEqual([1, SKETCH.most]);
    fake.answer(1);
    expect([shown(study).trials, study.stale, study.running]).toEqual([SKETCH.most, false, false]);
    study.follow(dragged(B), false);
    expect([study.stale, study.running, fake.queue.length]).toEqual([
      true,
      true,
      MOST_TRIALS / TRIALS_PER_BLOCK,
    ]);
  });

  test("frees every sum it opened", () => {
    const [fake, study] = start();
    for (const next of [A, B, C]) study.follow(fake.subject(next), false);
    expect(fake.open).toBe(1);
    study.close();
    expect(fake.open).toBe(0);
  });
});

function start(): [Fake, Study] {
  const fake = new Fake();
  return [fake, new Study(fake.openPool)];
}

function complete(fake: Fake, study: Study, of: Scenario): void {
  study.follow(fake.subject(of), false);
  fake.answer(1);
  vi.advanceTimersByTime(300);
  fake.answer(FIRST_PICTURE / TRIALS_PER_BLOCK - 1);
  expect(shown(study).trials).toBe(FIRST_PICTURE);
}
