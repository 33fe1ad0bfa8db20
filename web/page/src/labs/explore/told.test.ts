import { expect, test } from "vitest";
import { hiddenFrom, missingRanges } from "./told";

const twin = { sensors: [], proper: false, sentence: "" };

test("cause and twin are named", () => {
  expect(hiddenFrom({ cause: null, twin: null })).toBe("Every small motion is seen.");
  expect(hiddenFrom({ cause: "anchors-in-one-plane", twin: null })).toContain("anchors in one plane");
  expect(hiddenFrom({ cause: null, twin })).toContain("a mirrored body");
  expect(hiddenFrom({ cause: null, twin: { ...twin, proper: true } })).toContain("another pose");
});

test("ranges that cannot be measured are counted", () => {
  const available = [
    [true, false],
    [false, false],
  ];
  expect(missingRanges({ available })).toEqual({ missing: 3, all: 4 });
});
