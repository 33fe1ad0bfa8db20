import { expect, test } from "vitest";
import { tickLabel, ticks } from "./ticks";

test("linear ticks are equal round steps inside the range", () => {
  expect(ticks([0, 1], "linear", 5)).toEqual([0, 0.2, 0.4, 0.6, 0.8, 1]);
  expect(ticks([0.1, 6], "linear", 4)).toEqual([2, 4, 6]);
  expect(ticks([0, 0.03], "linear", 4)).toEqual([0, 0.01, 0.02, 0.03]);
});

test("logarithmic ticks are all digits, or 1, 2, 5, where they fit, else powers of ten", () => {
  expect(ticks([0.005, 0.01], "log", 6)).toEqual([0.005, 0.006, 0.007, 0.008, 0.009, 0.01]);
  expect(ticks([0.1, 1], "log", 6)).toEqual([0.1, 0.2, 0.5, 1]);
  expect(ticks([0.05, 20], "log", 4)).toEqual([0.1, 1, 10]);
  expect(ticks([1e-6, 1e6], "log", 5)).toEqual([1e-6, 1e-3, 1, 1e3, 1e6]);
});

test("there are never more than asked for, and always two to read a scale by", () => {
  for (const most of [2, 3, 5, 9])
    for (const range of [
      [0.002, 0.005],
      [0.5, 2],
      [0.01, 20],
      [1e-4, 5e3],
    ] as const) {
      const list = ticks(range, "log", most);
      expect(list.length).toBeGreaterThanOrEqual(2);
      expect(list.length).toBeLessThanOrEqual(Math.max(2, most));
    }
});

test("labels are short", () => {
  expect([0, 0.001, 0.05, 2000, 1e-5, 1e6].map(tickLabel)).toEqual([
    "0",
    "0.001",
    "0.05",
    "2000",
    "1e-5",
    "1e+6",
  ]);
});
