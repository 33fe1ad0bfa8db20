import { expect, test } from "vitest";
import type { Family } from "./family";
import { forLab, type Lab, labOf } from "./lab";
import { LABS } from "./labs";
import type { Scenario } from "./scenario";

const claiming = (key: string) => ({ claims: (document) => key in document }) as Family;
const [body, imu] = [claiming("anchors"), claiming("imu")];
const first = { name: "track", family: body } as Lab;
const second = { name: "localize", family: body } as Lab;
const other = { name: "indoor", family: imu } as Lab;
const labs = [first, second, other];
const scenario = { view: null } as unknown as Scenario;

test("the folders below labs/ are found, each with a name and a place of its own", () => {
  expect(LABS.map((lab) => lab.name)).toContain("track");
  expect(new Set(LABS.map((lab) => lab.name)).size).toBe(LABS.length);
  expect(new Set(LABS.map((lab) => lab.order)).size).toBe(LABS.length);
});

test("a scenario without a lab is for the first, one with an unknown lab for none", () => {
  expect(labOf(scenario, labs)).toBe(first);
  expect(labOf({ ...scenario, view: { lab: "localize" } }, labs)).toBe(second);
  expect(labOf({ ...scenario, view: { lab: "moon" } }, labs)).toBeUndefined();
});

test("a document that names no lab goes to the first one for documents like it", () => {
  expect(labOf({ version: 1, imu: {} }, labs)).toBe(other);
  expect(labOf({ version: 1, anchors: [] }, labs)).toBe(first);
  expect(labOf({ version: 1, imu: {}, view: { lab: "track" } }, labs)).toBe(first);
});

test("a scenario is marked for another lab without losing its other hints", () => {
  const hinted = { ...scenario, view: { camera: 1 } };
  expect(forLab(hinted, first, labs)).toBe(hinted);
  expect(forLab(hinted, second, labs).view).toEqual({ camera: 1, lab: "localize" });
  expect(labOf(forLab(hinted, second, labs), labs)).toBe(second);
});
