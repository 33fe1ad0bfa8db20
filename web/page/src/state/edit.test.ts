import { expect, test } from "vitest";
import type { Scenario } from "../scenario";
import {
  addAnchors,
  coordinateStep,
  newAnchorPosition,
  removeAnchors,
  roundTo,
  setEstimatorEnabled,
  withAnchors,
} from "./edit";

const scenario = {
  dimension: 3,
  anchors: [
    [0, 0, 0],
    [4, 0, 2],
    [0, 5, 1],
  ],
  estimators: { enabled: ["kf", "uc-kf"] },
  availability: { max_ranges: [5, null, 7], obstacles: [] },
  placement: { fixed: [0, 2] },
} as unknown as Scenario;

test("edits leave the old scenario alone", () => {
  const before = JSON.stringify(scenario);
  addAnchors(scenario, [[9, 9, 9]]);
  removeAnchors(scenario, [0]);
  expect(JSON.stringify(scenario)).toBe(before);
});

test("an added anchor is a new place with all coordinates", () => {
  const { anchors } = addAnchors(scenario, [newAnchorPosition(scenario)]);
  expect(anchors).toHaveLength(4);
  expect(anchors[3]).toHaveLength(3);
  expect(anchors.slice(0, 3)).not.toContainEqual(anchors[3]);
});

test("estimators stay in the listed order", () => {
  const order = ["kf", "ortho", "uc-kf"] as const;
  expect(setEstimatorEnabled(scenario, "ortho", true, order).estimators.enabled).toEqual([
    "kf",
    "ortho",
    "uc-kf",
  ]);
  expect(setEstimatorEnabled(scenario, "kf", false, order).estimators.enabled).toEqual(["uc-kf"]);
});

test("a room moves by centimetres, a field of a kilometre by metres", () => {
  expect(coordinateStep(scenario)).toBeCloseTo(0.01, 12);
  const field = { ...scenario, anchors: [[800, 0, 0]] };
  expect(coordinateStep(field)).toBe(1);
  expect(roundTo(0.1 + 0.2, 0.01)).toBe(0.3);
  expect(roundTo(1234.56, 1)).toBe(1235);
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
