import { beforeAll, describe, expect, test } from "vitest";
import { loadEngineForTests } from "../engine/testing";
import { LABS } from "../labs";
import { gesturesFor, keysFor, scopeOf } from "./help";

beforeAll(loadEngineForTests);

function helpOf(name: string): string {
  const lab = LABS.find((each) => each.name === name)!;
  const scenario = lab.preset(lab.firstPreset);
  // Explore would start its workers; what is asked of it does not depend on its run.
  const scope = scopeOf(lab, scenario, name === "explore" ? null : lab.compute(scenario));
  return [...keysFor(scope), ...gesturesFor(scope)].map((line) => line.join(": ")).join("\n");
}

describe("the help", () => {
  test.each([
    ["track", "anchor"],
    ["indoor", "beacon"],
    ["anchorless", "node"],
  ])("calls things by their names: %s has a(n) %s", (lab, noun) => {
    const help = helpOf(lab);
    expect(help).toMatch(new RegExp(`choose an? ${noun}\\b`));
    for (const other of ["anchor", "beacon", "node"].filter((each) => each !== noun))
      expect(help).not.toMatch(new RegExp(`\\b${other}s?\\b`));
  });

  test.each([
    ["track", { "body designer": false, "Draw…": false, Space: true, "goes to that time": true }],
    ["explore", { "body designer": true, "Draw…": true, Space: false }],
    ["localize", { "body designer": false, "Draw…": false, Space: false, "goes to that time": false }],
  ])("tells of what the lab has and of nothing else: %s", (lab, expected) => {
    const help = helpOf(lab);
    const told = Object.fromEntries(Object.keys(expected).map((what) => [what, help.includes(what)]));
    expect(told).toEqual(expected);
  });
});
