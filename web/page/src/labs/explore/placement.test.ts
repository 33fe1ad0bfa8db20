import { describe, expect, test } from "vitest";
import type { Advice } from "../../generated/Advice";
import type { Improvement } from "../../generated/Improvement";
import type { Scenario } from "../../scenario";
import type { Search } from "../../workers/messages";
import type { PoolListener } from "../../workers/pool";
import { downhillOf, formatValue, shareOfBest, withFixed } from "./placement";
import { PlacementSearch } from "./placement-search.svelte";

const placement = { criterion: "a", fixed: [] as number[] };
const scene = (x: number, fixed: number[] = []) =>
  ({ name: "", anchors: [[x], [9]], field: {}, placement: { ...placement, fixed } }) as unknown as Scenario;

/** A search whose workers the test plays: each result is the value found by a restart. */
function setup(restarts = 3, start = scene(0)) {
  let listener!: PoolListener<Search, Improvement>;
  let queue: readonly Search[] = [];
  const search = new PlacementSearch((given) => {
    listener = given;
    return { replace: (jobs) => (queue = jobs), close: () => (queue = []) };
  });
  search.restarts = restarts;
  const applied: Improvement[] = [];
  const state: { scenario: Scenario | null } = { scenario: start };
  const seek = () => search.start({ current: () => state.scenario, apply: (best) => applied.push(best) });
  const find = (restart: number, after: number | null, before: number | null = 2) =>
    listener.done(
      { scenario: start, restart },
      { restart, unit: "m", before, after, cause: null, anchors: [[after ?? 0], [9]] },
    );
  return {
    search,
    applied,
    state,
    seek,
    find,
    queue: () => queue,
    fail: (text: string) => listener.failed(text, true),
  };
}

describe("the search", () => {
  test("moves the anchors once, to the best of all restarts in whatever order they end, and says so of that problem alone", () => {
    const { search, applied, seek, find, queue } = setup();
    seek();
    expect(queue().map(({ restart }) => restart)).toEqual([0, 1, 2]);
    find(2, 1.5);
    find(0, 1);
    expect([search.done, search.running, applied.length]).toEqual([2, true, 0]);
    find(1, 1);
    expect(applied.map(({ restart, after }) => [restart, after])).toEqual([[0, 1]]);
    expect([search.running, search.outcomeFor(scene(1))]).toEqual([false, "Best of 3: 1.00 m."]);
    expect(search.outcomeFor(scene(1, [0]))).toBe("");
  });

  test("of two restarts that end alike the earlier one counts", () => {
    const { applied, seek, find } = setup(2);
    seek();
    find(1, 1);
    find(0, 1);
    expect(applied[0].restart).toBe(0);
  });

  test.each([
    ["worse", 2.5],
    ["equal", 2],
    ["without a bound", null],
  ])("never applies anchors that are %s", (_what, after) => {
    const { search, applied, seek, find } = setup(1);
    seek();
    find(0, after);
    expect(applied).toEqual([]);
    expect(search.outcomeFor(scene(0))).toBe("No better places were found.");
  });

  test("any bound is better than none", () => {
    const { applied, seek, find } = setup(1);
    seek();
    find(0, 7, null);
    expect(applied).toHaveLength(1);
  });

  test("cancelled, it stops its workers and moves nothing", () => {
    const { search, applied, seek, find, queue } = setup(2);
    seek();
    find(0, 1);
    search.cancel();
    find(1, 0.5);
    expect([applied, queue(), search.running]).toEqual([[], [], false]);
    expect(search.outcomeFor(scene(0))).toContain("Cancelled");
  });

  test("an edit meanwhile wins: what was found for the older scene is not applied", () => {
    const { search, applied, state, seek, find } = setup(1);
    seek();
    state.scenario = scene(5);
    find(0, 1);
    expect(applied).toEqual([]);
    expect(search.outcomeFor(scene(5))).toContain("has changed");
  });

  test("a document of another kind meanwhile ends it: its workers rest and nothing is said", () => {
    const { search, applied, state, seek, find, queue } = setup(2);
    seek();
    state.scenario = null;
    find(0, 1);
    expect([applied, queue(), search.running]).toEqual([[], [], false]);
    expect(search.outcomeFor(scene(0))).toBe("");
  });

  test("started again it begins at nothing", () => {
    const { search, applied, seek, find } = setup(2);
    seek();
    find(0, 1);
    seek();
    expect(search.done).toBe(0);
    find(0, 1.2);
    find(1, 1.3);
    expect(applied).toHaveLength(1);
  });

  test("tells why it ended", () => {
    const { search, seek, fail } = setup();
    seek();
    fail("Anchor 2 has no place.");
    expect([search.outcomeFor(scene(0)), search.running]).toEqual(["Anchor 2 has no place.", false]);
  });

  test("knows the best while free anchors move, not for another problem", () => {
    const { search, seek, find } = setup(1);
    seek();
    find(0, 1);
    expect(search.bestFor(scene(3))?.after).toBe(1);
    expect(search.bestFor(scene(0, [0]))).toBeNull();
  });
});

test("arrows go downhill, the steepest of length 1, none at anchors that stay", () => {
  const advice = {
    gradient: [
      [0, 4],
      [8, 0],
      [2, 0],
      [0, 0],
    ],
  } as unknown as Advice;
  expect(downhillOf(advice, [1])).toEqual([[0, -1], null, [-0.5, 0], null]);
  expect(downhillOf({ ...advice, gradient: [] }, [])).toEqual([]);
});

test("values are read in mm, m and degrees, and beside the best in per cent", () => {
  expect(formatValue(0.0055, "m")).toBe("5.50 mm");
  expect(formatValue(0.25, "m")).toBe("0.250 m");
  expect(formatValue(Math.PI / 180, "rad")).toBe("1.00 deg");
  expect(formatValue(null, "m")).toBe("no bound");
  expect(shareOfBest(2, 1)).toBe(50);
  expect(shareOfBest(null, 1)).toBeNull();
});

test("anchors that stay are listed once, in order", () => {
  const both = withFixed(withFixed(scene(0), 1, true), 0, true);
  expect(both.placement.fixed).toEqual([0, 1]);
  expect(withFixed(both, 0, false).placement.fixed).toEqual([1]);
});
