import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { NextPlace } from "../../generated/NextPlace";
import type { Scenario } from "../../scenario";
import type { BestNext, Scene } from "../../workers/messages";
import type { PoolListener } from "../../workers/pool";
import { GRACE, NextSearch, type OpenPool, PATIENCE } from "./next-search.svelte";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

const scenario = (seed: number, subject = "next_anchor") => ({ seed, field: { subject } }) as Scenario;
const placeOf = ({ seed }: Scenario) => ({ point: [seed] }) as NextPlace;

/** A pool that answers when it is told to. */
function setup(open?: OpenPool) {
  let listener!: PoolListener<Scene, BestNext>;
  let jobs: readonly Scene[] = [];
  let closed = 0;
  const pool: OpenPool = (told) => {
    listener = told;
    return { replace: (next) => void (jobs = next), close: () => void (closed += 1) };
  };
  const alone = vi.fn(placeOf);
  const search = new NextSearch(open ?? pool, alone);
  return {
    search,
    alone,
    answer: (asked: Scenario) => listener.done({ scenario: asked }, { place: placeOf(asked) }),
    fail: () => listener.failed("The workers stopped.", false),
    refuse: () => listener.failed("No place.", true),
    closed: () => closed,
    jobs: () => jobs,
  };
}

test("a worker finds the place, and what it says of an older scene is not heard", () => {
  const { search, alone, answer, jobs } = setup();
  const [older, newer] = [scenario(1), scenario(2)];
  search.show(older);
  search.show(newer);
  expect(jobs()).toEqual([{ scenario: newer }]);
  answer(older);
  expect([search.place, search.searching]).toEqual([null, true]);
  answer(newer);
  expect([search.place?.point, search.searching]).toEqual([[2], false]);
  expect(alone).not.toHaveBeenCalled();
});

test("the place of the scene before stands for a moment only", () => {
  const { search, answer } = setup();
  const [older, newer] = [scenario(1), scenario(2)];
  search.show(older);
  answer(older);
  search.show(newer);
  vi.advanceTimersByTime(GRACE - 1);
  expect(search.place?.point).toEqual([1]);
  vi.advanceTimersByTime(1);
  expect([search.place, search.searching]).toEqual([null, true]);
});

test("nothing is searched where the field shows something else", () => {
  const { search, answer, jobs } = setup();
  const asked = scenario(1);
  search.show(asked);
  search.show(scenario(2, "body"));
  answer(asked);
  expect([search.place, search.searching]).toEqual([null, false]);
  expect(jobs()).toEqual([{ scenario: asked }]);
});

test("a search that takes long ends where another one is wanted, or none", () => {
  const { search, answer, closed } = setup();
  const [first, second, third] = [1, 2, 3].map((seed) => scenario(seed));
  search.show(first);
  vi.advanceTimersByTime(PATIENCE - 1);
  search.show(second);
  expect(closed()).toBe(0);
  vi.advanceTimersByTime(2);
  search.show(third);
  expect(closed()).toBe(1);
  answer(third);
  vi.advanceTimersByTime(2 * PATIENCE);
  search.show(first);
  expect(closed()).toBe(1);
  search.close();
  expect([closed(), search.place, search.searching]).toEqual([2, null, false]);
  search.show(scenario(4, "body"));
  expect(closed()).toBe(3);
});

test("where the engine refuses the scenario there is no place, and workers are asked again", () => {
  const { search, alone, refuse, answer, jobs } = setup();
  search.show(scenario(1));
  refuse();
  expect([search.place, search.searching]).toEqual([null, false]);
  const next = scenario(2);
  search.show(next);
  expect(jobs()).toEqual([{ scenario: next }]);
  answer(next);
  expect(search.place?.point).toEqual([2]);
  expect(alone).not.toHaveBeenCalled();
});

test("without workers the page searches itself, now and from then on", () => {
  const lost = setup();
  lost.search.show(scenario(1));
  lost.fail();
  expect([lost.search.place?.point, lost.search.searching]).toEqual([[1], false]);
  lost.search.show(scenario(2));
  expect(lost.search.place?.point).toEqual([2]);
  const none = setup(() => {
    throw new Error("No workers here.");
  });
  none.search.show(scenario(3));
  expect(none.search.place?.point).toEqual([3]);
});
