import { expect, test } from "vitest";
import { logLevels } from "./log-levels";

test("levels are 1, 2 and 5 times powers of ten, ends included", () => {
  expect(logLevels(0.02, 1, 12)).toEqual([0.02, 0.05, 0.1, 0.2, 0.5, 1]);
  expect(logLevels(0.021, 2.9, 12)).toEqual([0.05, 0.1, 0.2, 0.5, 1, 2]);
});

test("ends that a factor moved by a bit are still levels", () => {
  const degrees = 180 / Math.PI;
  expect(logLevels((0.5 / degrees) * degrees, (10 / degrees) * degrees, 12)).toEqual([0.5, 1, 2, 5, 10]);
});

test("long scales have fewer levels", () => {
  expect(logLevels(1e-3, 10, 6)).toEqual([0.001, 0.01, 0.1, 1, 10]);
  expect(logLevels(1e-6, 1e6, 6)).toEqual([1e-6, 1e-3, 1, 1e3, 1e6]);
});

test("short scales have finer levels", () => {
  expect(logLevels(0.03, 0.14, 7)).toEqual([0.03, 0.04, 0.05, 0.07, 0.1]);
  expect(logLevels(0.0052, 0.0098, 7)).toEqual([0.006, 0.007, 0.008, 0.009]);
  expect(logLevels(1.11, 1.49, 7)).toEqual([1.2, 1.3, 1.4]);
  expect(logLevels(1.11, 1.19, 7)).toEqual([]);
});
