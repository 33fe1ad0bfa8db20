import { describe, expect, test } from "vitest";
import { bodyView, directionOf } from "./body-view";
import { axisArrows, dotsOf, gridOf, numberPlace, outlineOf } from "./inset-picture";

const viewport = { width: 200, height: 200 };
const view = (side: Parameters<typeof directionOf>[0]) => bodyView(directionOf(side), 1, viewport);

test("an axis seen end on has no arrow, nor has the third one in the plane", () => {
  const names = (side: Parameters<typeof directionOf>[0], dimension: number) =>
    axisArrows(view(side), dimension, 0.8).map(({ name }) => name);
  expect(names("space", 3)).toEqual(["x", "y", "z"]);
  expect(names("front", 3)).toEqual(["x", "z"]);
  expect(names("side", 3)).toEqual(["y", "z"]);
  expect(names("top", 3)).toEqual(["x", "y"]);
  expect(names("plane", 2)).toEqual(["x", "y"]);
});

test("an axis is as long as the metres it stands for", () => {
  const [x] = axisArrows(view("front"), 3, 0.5);
  expect(x.tip.x).toBeCloseTo(150, 9);
  expect(x.tip.y).toBeCloseTo(100, 9);
});

test("numbers stand beside their sensors, away from the origin", () => {
  expect(numberPlace(view("top"), { x: 150, y: 100 }, 10)).toEqual({ x: 160, y: 100 });
  const over = numberPlace(view("top"), { x: 100, y: 100 }, 10);
  expect(Math.hypot(over.x - 100, over.y - 100)).toBeCloseTo(10, 9);
});

test("the outline of a square has four edges and no diagonal", () => {
  const square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]; // prettier-ignore
  const at = square.map(([x, y]) => ({ x: 100 * x, y: 100 * y }));
  const { edges } = outlineOf(square, at);
  expect(edges.match(/M/g)).toHaveLength(4);
  expect(edges).not.toContain("M0 0L100 100");
});

describe("the grid", () => {
  test("has a line through the origin and round distances", () => {
    const grid = gridOf(bodyView(directionOf("top"), 1.1, viewport), 1.1);
    const across = [...grid.matchAll(/M([\d.]+) 0V/g)].map((match) => Number(match[1]));
    expect(across).toEqual([9.1, 54.5, 100, 145.5, 190.9]);
  });
});

test("a cloud is a dot a point, and nothing without points", () => {
  expect(dotsOf(view("top"), [])).toBe("");
  expect(dotsOf(view("top"), [[0, 0, 0], [0.5, 0, 0]])).toBe("M100 100h0M150 100h0"); // prettier-ignore
});
