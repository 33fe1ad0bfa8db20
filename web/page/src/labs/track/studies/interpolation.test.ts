import { expect, test } from "vitest";
import { Interpolation } from "./interpolation";

const curve = new Interpolation(Float64Array.of(0.01, 0.1, 1), Float64Array.of(20, 4, 0));

test("a curve goes through its points and straight between them over the logarithm", () => {
  expect([0.01, 0.1, 1].map((place) => curve.at(place))).toEqual([20, 4, 0]);
  expect(curve.at(Math.sqrt(0.1))).toBeCloseTo(2, 12);
});

test("beyond its ends it stays as it is there", () => {
  expect([0, 1e-5, 50].map((place) => curve.at(place))).toEqual([20, 20, 0]);
  expect([30, -1].map((value) => curve.where(value))).toEqual([0.01, 1]);
});

test("a place is found again from its value", () => {
  for (const place of [0.013, 0.1, 0.5]) expect(curve.where(curve.at(place))).toBeCloseTo(place, 12);
});
