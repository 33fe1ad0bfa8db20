import { expect, test } from "vitest";
import { coordinateStep, newAnchorPosition, roundTo, switched } from "./edit";

const room = {
  dimension: 3,
  anchors: [
    [0, 0, 0],
    [4, 0, 2],
    [0, 5, 1],
  ],
};

test("an added anchor is a new place with all coordinates", () => {
  const position = newAnchorPosition(room);
  expect(position).toHaveLength(3);
  expect(room.anchors).not.toContainEqual(position);
});

test("what is switched on stays in the listed order", () => {
  const order = ["kf", "ortho", "uc-kf"] as const;
  expect(switched(["kf", "uc-kf"], ["ortho"], true, order)).toEqual(["kf", "ortho", "uc-kf"]);
  expect(switched(["kf", "uc-kf"], ["kf"], false, order)).toEqual(["uc-kf"]);
});

test("a room moves by centimetres, a field of a kilometre by metres", () => {
  expect(coordinateStep(room)).toBeCloseTo(0.01, 12);
  const field = { anchors: [[800, 0, 0]] };
  expect(coordinateStep(field)).toBe(1);
  expect(roundTo(0.1 + 0.2, 0.01)).toBe(0.3);
  expect(roundTo(1234.56, 1)).toBe(1235);
});
