import { expect, test } from "vitest";
import { logLevels } from "./log-levels";

test("levels are 1, 2 and 5 times powers of ten, ends included", () => {
  expect(logLevels(0.02, 1, 12)).toEqual([0.02, 0.05, 0.1, 0.2, 0.5, 1]);
  expect(logLevels(0.021, 0.99, 12)).toEqual([0.05, 0.1, 0.2, 0.5]);
});

test("ends that a factor moved by a bit are still levels", () => {
  const degrees = 180 / Math.PI;
  expect(logLevels((0.7 / degrees) * degrees, (5 / degrees) * degrees, 12)).toEqual([1, 2, 5]);
});

test("long scales have fewer levels", () => {
  expect(logLevels(1e-3, 10, 6)).toEqual([0.001, 0.01, 0.1, 1, 10]);
  expect(logLevels(1e-6, 1e6, 6)).toEqual([1e-6, 1e-3, 1, 1e3, 1e6]);
});

test("short scales have finer levels, and very short ones may have none", () => {
  expect(logLevels(0.035, 0.14, 7)).toEqual([0.04, 0.05, 0.07, 0.1]);
  expect(logLevels(0.21, 0.49, 7)).toEqual([0.3, 0.4]);
  expect(logLevels(1.1, 1.4, 7)).toEqual([]);
});
