import { expect, test } from "vitest";
import { sensorStep, shiftedPlace, withoutSensor, withSensorAdded, withSensorAt } from "./body-edits";

const body = [
  [0, 0, 0.2],
  [0.3, 0, 0],
];

test("edits leave the old body as it was", () => {
  const before = JSON.stringify(body);
  expect(withSensorAdded(body)).toHaveLength(3);
  expect(withoutSensor(body, 0)).toEqual([[0.3, 0, 0]]);
  expect(withSensorAt(body, 1, [1, 2, 3])[1]).toEqual([1, 2, 3]);
  expect(JSON.stringify(body)).toBe(before);
});

test("a new sensor stands on no other, also beside a single one", () => {
  expect(withSensorAdded(body)[2]).not.toEqual(body[1]);
  expect(withSensorAdded([[0, 0]])).toEqual([
    [0, 0],
    [0.1, 0],
  ]);
});

test("a dragged sensor lands on the grid, and keeps the coordinates it is not dragged along", () => {
  expect(shiftedPlace([0.1234, 0.28868, -0.05], [0.031, 0, -1e-17], 0.01)).toEqual([0.15, 0.28868, -0.05]);
});

test("the grid is a power of ten, between a twentieth and a two-hundredth of the body", () => {
  for (const size of [0.02, 0.2884, 0.9, 1.44, 30]) {
    const step = sensorStep([
      [0, 0],
      [size, 0],
    ]);
    expect(Math.log10(step) % 1).toBeCloseTo(0, 12);
    expect(step).toBeLessThanOrEqual(size / 20);
    expect(step).toBeGreaterThan(size / 201);
  }
  expect(sensorStep([[1, 1]])).toBe(0.01);
});
