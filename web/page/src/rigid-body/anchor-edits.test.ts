import { expect, test } from "vitest";
import type { Scenario } from "../scenario";
import { addAnchors, removeAnchors, withAnchors } from "./anchor-edits";

const scenario = {
  dimension: 3,
  anchors: [
    [0, 0, 0],
    [4, 0, 2],
    [0, 5, 1],
  ],
  availability: { max_ranges: [5, null, 7], obstacles: [] },
  placement: { fixed: [0, 2] },
} as unknown as Scenario;

test("edits leave the old scenario alone", () => {
  const before = JSON.stringify(scenario);
  addAnchors(scenario, [[9, 9, 9]]);
  removeAnchors(scenario, [0]);
  expect(JSON.stringify(scenario)).toBe(before);
});

test("limits of range and fixed anchors stay with their anchors", () => {
  const fewer = removeAnchors(scenario, [1]);
  expect([fewer.availability.max_ranges, fewer.placement.fixed]).toEqual([
    [5, 7],
    [0, 1],
  ]);
  const none = removeAnchors(scenario, [0, 2]);
  expect([none.availability.max_ranges, none.placement.fixed]).toEqual([[null], []]);
  expect(addAnchors(scenario, [[9, 9, 9]]).availability.max_ranges).toEqual([5, null, 7, null]);
  const unlimited = { ...scenario, availability: { ...scenario.availability, max_ranges: [] } };
  expect(addAnchors(unlimited, [[9, 9, 9]]).availability.max_ranges).toEqual([]);
  const other = withAnchors(scenario, scenario.anchors.slice(0, 2));
  expect([other.availability.max_ranges, other.placement.fixed]).toEqual([[5, null], [0]]);
});
