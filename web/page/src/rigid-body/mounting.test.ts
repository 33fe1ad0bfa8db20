import { beforeAll, expect, test } from "vitest";
import { preset } from "../engine";
import { loadEngineForTests } from "../engine/testing";
import type { Scenario } from "../scenario";
import { CLOUD_TRIALS, cloudOf, onMounting, positionFloor, toldMounting } from "./mounting";

beforeAll(loadEngineForTests);

const mounted = (name: string, mounting_sigma: number): Scenario => ({ ...preset(name), mounting_sigma });

test("each sensor has a cloud as wide as the error, around its place", () => {
  for (const name of ["room", "planar"]) {
    const scenario = mounted(name, 0.02);
    const { sensors, dimension } = scenario;
    const cloud = cloudOf(scenario);
    expect(cloud).toHaveLength(CLOUD_TRIALS * sensors.length);
    const errors = cloud.flatMap((place, index) =>
      sensors[index % sensors.length].map((value, axis) => place[axis] - value),
    );
    const deviation = Math.sqrt(errors.reduce((sum, error) => sum + error ** 2, 0) / errors.length);
    const standardError = 1 / Math.sqrt(2 * errors.length);
    expect(Math.abs(deviation / 0.02 - 1)).toBeLessThan(4.5 * standardError);
    if (dimension === 2) expect(cloud.every(([, , z]) => z === 0)).toBe(true);
  }
});

test("a cloud is drawn once for a scenario, and none where there is no error", () => {
  const scenario = mounted("room", 0.02);
  expect(cloudOf(scenario)).toBe(cloudOf(scenario));
  expect(cloudOf({ ...scenario })).toEqual(cloudOf(scenario));
  expect(cloudOf(mounted("room", 0))).toEqual([]);
  expect(cloudOf({ ...scenario, seed: scenario.seed + 1 })).not.toEqual(cloudOf(scenario));
});

test("what it costs is told where there is an error", () => {
  const scenario = { ...mounted("room", 0.1), sensors: Array.from({ length: 10 }, () => [0, 0, 0]) };
  expect(positionFloor(scenario)).toBeCloseTo(0.0548, 4);
  expect(onMounting(scenario).warning).toBe(true);
  expect(onMounting(scenario).text).toContain("0.0548 m");
  expect(toldMounting(scenario).join()).toContain("0.100 m off their places");
  expect(onMounting(mounted("room", 0)).warning).toBe(false);
  expect(toldMounting(mounted("room", 0))).toEqual([]);
});
