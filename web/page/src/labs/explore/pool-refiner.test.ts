import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Scenario } from "../../scenario";
import type { FieldRows, RowValues } from "../../workers/messages";
import type { PoolListener } from "../../workers/pool";
import type { Field, Refiner } from "./field-source";
import { type OpenPool, PoolRefiner, REST } from "./pool-refiner";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

const scenario = (seed: number) => ({ seed }) as Scenario;

/** A pool that answers when it is told to: cells tell scenario and row. */
function setup(open?: OpenPool) {
  let listener!: PoolListener<FieldRows, RowValues>;
  let jobs: FieldRows[] = [];
  const lists: number[] = [];
  let closed = 0;
  const found: Field[] = [];
  const idle: [number, readonly number[]][] = [];
  const pool: OpenPool = (told) => {
    listener = told;
    return {
      replace: (next) => void (lists.push(next.length), (jobs = [...next])),
      close: () => void (closed += 1),
    };
  };
  const fallback: Refiner = {
    refine: ({ seed }, resolutions) => void idle.push([seed, resolutions]),
    cancel: () => undefined,
    close: () => undefined,
  };
  const layout = (_: Scenario, width: number) => ({
    corner: [0, 0, 0] as [number, number, number],
    u: [2, 0, 0] as [number, number, number],
    v: [0, 1, 0] as [number, number, number],
    width,
    height: width / 2,
  });
  const refiner = new PoolRefiner(layout, open ?? pool, fallback);
  const answer = (job: FieldRows) =>
    listener.done(
      job,
      Float32Array.from(
        { length: job.resolution * job.count },
        (_, at) => 1000 * job.scenario.seed + job.first + Math.floor(at / job.resolution),
      ),
    );
  return {
    refine: (seed: number) => refiner.refine(scenario(seed), [128, 256], (field) => found.push(field)),
    fail: () => listener.failed("The workers stopped.", false),
    refuse: () => listener.failed("No field.", true),
    close: () => refiner.close(),
    closed: () => closed,
    answer,
    jobs: () => jobs,
    lists,
    found,
    idle,
  };
}

const told = (fields: readonly Field[]) =>
  fields.map(({ scenario: { seed }, resolution }) => [seed, resolution]);

test("workers find finer fields in blocks, whatever the order in which these come", () => {
  const { refine, answer, jobs, found } = setup();
  refine(3);
  vi.advanceTimersByTime(REST);
  for (const job of jobs().toSorted((a, b) => a.resolution - b.resolution || b.first - a.first)) answer(job);
  expect(told(found)).toEqual([
    [3, 128],
    [3, 256],
  ]);
  const { values, width, height } = found[1];
  expect(values).toHaveLength(width * height);
  expect(Array.from(values).every((value, at) => value === 3000 + Math.floor(at / width))).toBe(true);
});

test("a coarser field that comes after a finer one is not told", () => {
  const { refine, answer, jobs, found } = setup();
  refine(3);
  vi.advanceTimersByTime(REST);
  for (const job of jobs().toSorted((a, b) => b.resolution - a.resolution)) answer(job);
  expect(told(found)).toEqual([[3, 256]]);
});

test("workers are not asked while one scenario follows the other", () => {
  const { refine, lists, jobs } = setup();
  for (let seed = 0; seed < 20; seed++) {
    refine(seed);
    vi.advanceTimersByTime(REST - 1);
  }
  expect(lists).toEqual([]);
  vi.advanceTimersByTime(1);
  expect(lists).toHaveLength(1);
  expect(jobs().every((job) => job.scenario.seed === 19)).toBe(true);
});

test("the next scenario drops what is under way; a late answer is not told", () => {
  const { refine, answer, jobs, lists, found } = setup();
  refine(1);
  vi.advanceTimersByTime(REST);
  const old = jobs();
  refine(2);
  expect(lists.at(-1)).toBe(0);
  old.forEach(answer);
  vi.advanceTimersByTime(REST);
  old.forEach(answer);
  expect(found).toEqual([]);
  jobs().forEach(answer);
  expect(told(found)).toEqual([
    [2, 128],
    [2, 256],
  ]);
});

test("where the engine refuses the field it stays coarse, and workers are asked for the next one", () => {
  const { refine, refuse, jobs, found, idle } = setup();
  refine(1);
  vi.advanceTimersByTime(REST);
  refuse();
  refine(2);
  vi.advanceTimersByTime(REST);
  expect([found, idle]).toEqual([[], []]);
  expect(jobs().every((job) => job.scenario.seed === 2)).toBe(true);
});

test("where nobody looks the workers end, and come again", () => {
  const { refine, close, closed, answer, jobs, found } = setup();
  refine(1);
  vi.advanceTimersByTime(REST);
  const old = jobs();
  close();
  old.forEach(answer);
  expect([closed(), found]).toEqual([1, []]);
  refine(2);
  vi.advanceTimersByTime(REST);
  jobs().forEach(answer);
  expect(told(found).at(-1)).toEqual([2, 256]);
});

test("where workers stop, what is missing is computed in idle moments, and so is all that follows", () => {
  const { refine, fail, answer, jobs, found, idle } = setup();
  refine(1);
  vi.advanceTimersByTime(REST);
  jobs()
    .filter((job) => job.resolution === 128)
    .forEach(answer);
  fail();
  expect(told(found)).toEqual([[1, 128]]);
  expect(idle).toEqual([[1, [256]]]);
  refine(2);
  expect(idle[1]).toEqual([2, [128, 256]]);
});

test("where workers cannot be started the idle moments take over", () => {
  const { refine, idle } = setup(() => {
    throw new Error("No workers here.");
  });
  refine(1);
  vi.advanceTimersByTime(REST);
  expect(idle).toEqual([[1, [128, 256]]]);
});
