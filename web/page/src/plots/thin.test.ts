import { expect, test } from "vitest";
import { timeAxis } from "./spec";
import { drawnSteps, nearestStep, stepsPerBucket, thin } from "./thin";

test("a run that fits is drawn as it is, with gaps where there is no number", () => {
  expect(stepsPerBucket(500)).toBe(1);
  expect(thin(Float64Array.of(3, NaN, 1), 1)).toEqual([3, null, 1]);
});

test.each([501, 1000, 1003, 9999])(
  "%i steps become at most 500 points, on times that never go back",
  (steps) => {
    const size = stepsPerBucket(steps);
    const at = drawnSteps(steps, size);
    const values = thin(new Float64Array(steps).fill(1), size);
    expect(at.length).toBeLessThanOrEqual(500);
    expect(values).toHaveLength(at.length);
    expect(at).toEqual(at.toSorted((a, b) => a - b));
    expect(at[at.length - 1]).toBeLessThan(steps);
  },
);

test("no peak and no dip is lost, and the earlier one stays the earlier one", () => {
  const values = new Float64Array(1000).fill(5);
  values[437] = 99;
  values[802] = -7;
  const drawn = thin(values, stepsPerBucket(1000));
  expect(drawn).toContain(99);
  expect(drawn).toContain(-7);
  expect(thin(Float64Array.of(1, 9, 2, 0), 4)).toEqual([9, 0]);
  expect(thin(Float64Array.of(1, 0, 9, 2), 4)).toEqual([0, 9]);
});

test("a bucket without a number is a gap", () => {
  expect(thin(Float64Array.of(NaN, NaN, 4, NaN), 2)).toEqual([null, null, 4, 4]);
});

test("the nearest step is found on uneven times", () => {
  const times = timeAxis(Float64Array.of(0.1, 0.2, 0.5, 2));
  expect([-1, 0.14, 0.16, 0.36, 1.2, 1.3, 9].map((time) => nearestStep(times, time))).toEqual([
    0, 0, 1, 2, 2, 3, 3,
  ]);
});

test("on a logarithmic axis the nearest step is the one that looks nearest", () => {
  const values = Float64Array.of(1, 10, 100);
  const steps = (scale: "log" | "linear") => [2, 4, 40].map((place) => nearestStep({ values, scale }, place));
  expect(steps("log")).toEqual([0, 1, 2]);
  expect(steps("linear")).toEqual([0, 0, 1]);
});
