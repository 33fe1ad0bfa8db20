import { expect, test } from "vitest";
import { STOPS, type SliderScale, stopOf, valueOf } from "./slider";

const SCALES: SliderScale[] = [
  { min: 0, max: 90 },
  { min: 1e-4, max: 10, log: true },
  { min: 1e-3, max: 30, log: true, zero: true },
];

test("every stop comes back from the value that it stands for", () => {
  for (const scale of SCALES)
    for (let stop = 0; stop <= STOPS; stop += 7)
      expect(Math.abs(stopOf(valueOf(stop, scale), scale) - stop)).toBeLessThanOrEqual(1);
});

test("the ends are the limits, and what lies beyond stands at an end", () => {
  for (const scale of SCALES) {
    expect(valueOf(STOPS, scale)).toBe(scale.max);
    expect(stopOf(1e9, scale)).toBe(STOPS);
    expect(valueOf(0, scale)).toBe(scale.zero ? 0 : scale.min);
    expect(stopOf(-1, scale)).toBe(0);
  }
});

test("a small value that is not 0 does not look like 0", () => {
  expect(stopOf(1e-9, SCALES[2])).toBe(1);
});
