import { expect, test } from "vitest";
import type { Scenario } from "../scenario";
import { differsAt, valueAt, withValue } from "./path";

const scenario = {
  seed: 1,
  noise: { kind: "range", sigma: 0.1 },
  motion: { velocity: [1, 2, 3], sigma_t: 0.5 },
} as unknown as Scenario;

test("values are found by the path that the engine's problems name", () => {
  expect(valueAt(scenario, "seed")).toBe(1);
  expect(valueAt(scenario, "motion.velocity[1]")).toBe(2);
  expect(valueAt(scenario, "noise")).toEqual({ kind: "range", sigma: 0.1 });
});

test("a place that is not there is undefined, however deep", () => {
  expect(valueAt(scenario, "noise.zeta_db")).toBeUndefined();
  expect(valueAt(scenario, "motion.path.radius")).toBeUndefined();
});

test("a value is replaced, the old scenario stays, and what is beside is shared", () => {
  const before = JSON.stringify(scenario);
  const next = withValue(scenario, "motion.velocity[2]", 9);
  expect(next.motion.velocity).toEqual([1, 2, 9]);
  expect(next.noise).toBe(scenario.noise);
  expect(JSON.stringify(scenario)).toBe(before);
});

test("scenarios differ where values do, and only there", () => {
  const next = withValue(scenario, "motion.velocity[0]", -1);
  expect(differsAt(scenario, next, ["motion.velocity"])).toBe(true);
  expect(differsAt(scenario, next, ["seed", "noise", "motion.sigma_t"])).toBe(false);
  expect(
    differsAt(scenario, withValue(scenario, "noise", { kind: "toa", zeta_db: 60 }), ["noise.sigma"]),
  ).toBe(true);
});
