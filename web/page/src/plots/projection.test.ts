import { expect, test } from "vitest";
import { Projection } from "./projection";

const box = { left: 100, top: 20, width: 400, height: 200 };

test.each(["log", "linear"] as const)("pixels and back: %s", (scale) => {
  const projection = new Projection(box, 2, [1, 10], scale, [0.01, 1], scale);
  expect([projection.left, projection.right, projection.top, projection.bottom]).toEqual([50, 250, 10, 110]);
  expect(projection.along(projection.x(3.7))).toBeCloseTo(3.7, 12);
  for (const value of [0.01, 0.2, 1]) expect(projection.levelAt(projection.y(value))).toBeCloseTo(value, 12);
});

test("logarithmic axes have their geometric mean in the middle; what lies beyond stays at the end", () => {
  const projection = new Projection(box, 1, [0.1, 10], "log", [0.01, 1], "log");
  expect(projection.y(0.1)).toBeCloseTo(120, 9);
  expect(projection.x(1)).toBeCloseTo(300, 9);
  expect(projection.clampedY(50)).toBe(20);
  expect(projection.clampedY(1e-9)).toBe(220);
});
