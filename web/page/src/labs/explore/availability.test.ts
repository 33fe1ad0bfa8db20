import { expect, test } from "vitest";
import type { Scenario } from "../../scenario";
import { newObstacle, withLimit, withNumber, withObstacles } from "./availability";

const scenario = {
  dimension: 3,
  anchors: [
    [0, 0, 0],
    [10, 0, 3],
    [10, 8, 0],
  ],
  start: { position: [4, 4, 1] },
  availability: { max_ranges: [], obstacles: [] },
} as unknown as Scenario;

test("the first limit gives every anchor a place, the last one taken away none", () => {
  const limited = withLimit(scenario, 1, 6);
  expect(limited.availability.max_ranges).toEqual([null, 6, null]);
  expect(withLimit(limited, 1, null).availability.max_ranges).toEqual([]);
  expect(scenario.availability.max_ranges).toEqual([]);
});

test("new walls and boxes lie among the anchors and have a size", () => {
  expect(newObstacle(scenario, "wall")).toMatchObject({ from: [7, 2.4], to: [7, 5.6] });
  const box = newObstacle(scenario, "box");
  if (box.kind !== "box") throw new Error("no box");
  expect(box.high.every((value, axis) => value > box.low[axis])).toBe(true);
  const flat = { ...scenario, anchors: scenario.anchors.map((anchor) => anchor.slice(0, 2)) };
  expect(newObstacle(flat, "box")).toMatchObject({ low: [7, 3.2] });
});

test("a number of an obstacle changes alone", () => {
  const wall = newObstacle(scenario, "wall");
  expect(withNumber(wall, "to", 1, 9)).toEqual({ ...wall, to: [7, 9] });
  expect(withNumber(wall, "top", null, 2)).toEqual({ ...wall, top: 2 });
  expect(withObstacles(scenario, [wall]).availability).toEqual({ max_ranges: [], obstacles: [wall] });
});
