import { converter, differenceCiede2000, wcagContrast } from "culori";
import { describe, expect, test } from "vitest";
import { BOUND_LOOKS } from "../labs/track/plots";
import { ESTIMATORS } from "../scenario";
import { type Eye, EYES, tokensOf } from "./eyes.testing";
import { MARKS, THEMES } from "./palette";

/** CIEDE2000: 1 is about what a trained eye just sees with both colours side by side; 10 is plain at a glance. */
const LEAST_DIFFERENCE = 10;
/** WCAG 2.2: text, and lines and marks that carry meaning. */
const LEAST_TEXT_CONTRAST = 4.5;
const LEAST_LINE_CONTRAST = 3;

const LINES = [...ESTIMATORS.map((estimator) => estimator.name as string), "truth"];
const TEXTS: readonly (readonly [string, readonly string[]])[] = [
  ["ink", ["surface", "page", "raised", "scene"]],
  ["ink-soft", ["surface", "page", "raised", "scene"]],
  ["accent", ["surface", "page", "raised", "scene"]],
  ["on-accent", ["accent"]],
  ["warning", ["warning-surface", "surface"]],
];

/** Pairs of colours that are less than the least difference apart. */
function confused(tokens: Record<string, string>, eye: Eye): string[] {
  const [difference, rgb] = [differenceCiede2000(), converter("rgb")];
  return LINES.flatMap((a, i) =>
    LINES.slice(i + 1).flatMap((b) => {
      const apart = difference(eye(rgb(tokens[a])!), eye(rgb(tokens[b])!));
      return apart < LEAST_DIFFERENCE ? [`${a} and ${b} are ${apart.toFixed(1)} apart`] : [];
    }),
  );
}

describe.each(THEMES)("the %s theme", (theme) => {
  const tokens = tokensOf(theme);

  test.each(Object.entries(EYES))("tells estimators and truth apart for %s", (_name, eye) => {
    expect(confused(tokens, eye)).toEqual([]);
  });

  test("has text that can be read", () => {
    for (const [text, grounds] of TEXTS)
      for (const ground of grounds)
        expect(wcagContrast(tokens[text], tokens[ground]), `${text} on ${ground}`).toBeGreaterThanOrEqual(
          LEAST_TEXT_CONTRAST,
        );
  });

  test("has lines, marks and field borders that can be seen", () => {
    for (const line of [...LINES, "bound", "anchor", "field-line"])
      for (const ground of ["scene", "surface"])
        expect(wcagContrast(tokens[line], tokens[ground]), `${line} on ${ground}`).toBeGreaterThanOrEqual(
          LEAST_LINE_CONTRAST,
        );
  });
});

test("the measure finds colours that are confused", () => {
  const redAndGreen = { ...tokensOf("light"), kf: "#b36a00", eskf: "#8f7a00" };
  expect(confused(redAndGreen, EYES["three receptors"])).toEqual([]);
  expect(confused(redAndGreen, EYES["deuteranopia"])).not.toEqual([]);
});

test("shape or dash doubles every colour", () => {
  const marks = ESTIMATORS.map((estimator) => MARKS[estimator.name]);
  expect(new Set(marks).size).toBe(marks.length);
  expect(marks).not.toContain(undefined);
  const dashes = Object.values(BOUND_LOOKS).map((look) => look.dash.join());
  expect(new Set(dashes).size).toBe(dashes.length);
});
