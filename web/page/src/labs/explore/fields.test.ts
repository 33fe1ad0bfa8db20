import { expect, test } from "vitest";
import { scaleOf } from "./fields";

test("the scale has round ends around the bounds, and none of the places without one", () => {
  const values = Float32Array.from({ length: 100 }, (_, index) => 0.013 + 0.001 * index);
  const ends = scaleOf(values, 1);
  expect([ends.low, ends.high].map((end) => Number(end.toPrecision(6)))).toEqual([0.01, 0.2]);
  expect(scaleOf(Float32Array.of(...values, 1e30, 3e30), 1)).toEqual(ends);
});

test("angles are round in degrees", () => {
  const { low, high } = scaleOf(Float32Array.of(0.02, 0.03, 0.05), 180 / Math.PI);
  expect([low, high].map((end) => Number(((end * 180) / Math.PI).toPrecision(6)))).toEqual([1, 2]);
});

test("a field without any bound, and one of a single value, still have a scale", () => {
  const { low, high } = scaleOf(Float32Array.of(1e30, 1e30), 1);
  expect(high).toBeGreaterThan(low);
  const single = scaleOf(Float32Array.of(0.2), 1);
  expect(single.high).toBeGreaterThan(single.low);
  expect(single.low).toBeGreaterThan(0);
});
