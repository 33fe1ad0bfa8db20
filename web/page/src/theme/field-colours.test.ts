import { converter, formatHex, wcagContrast } from "culori";
import { describe, expect, test } from "vitest";
import { type Eye, EYES, tokensOf } from "./eyes.testing";
import { colourAt, FIELD_STOPS, mix, type Rgb } from "./field-colours";
import { parseHex, THEMES } from "./palette";

const [lab, rgb] = [converter("lab"), converter("rgb")];

/** How much lighter each stop is than the one before, in CIELAB's 0..100. */
function lighter(stops: readonly string[], eye: Eye): number[] {
  const lightness = stops.map((stop) => lab(eye(rgb(stop)!))!.l);
  return lightness.slice(1).map((l, i) => l - lightness[i]);
}

test.each(Object.entries(EYES))(
  "each stop of the scale is lighter than the one before for %s",
  (_name, eye) => {
    expect(Math.min(...lighter(FIELD_STOPS, eye))).toBeGreaterThan(2);
  },
);

test("the steps of the scale are even", () => {
  const steps = lighter(FIELD_STOPS, EYES["three receptors"]);
  expect(Math.max(...steps) / Math.min(...steps)).toBeLessThan(1.5);
  const rainbow = lighter(["#0000ff", "#00ffff", "#00ff00", "#ffff00", "#ff0000"], EYES["three receptors"]);
  expect(Math.min(...rainbow)).toBeLessThan(0);
});

const parsed = (hex: string): Rgb => parseHex(hex, 1).slice(0, 3) as unknown as Rgb;
const hexOf = ([r, g, b]: Rgb) => formatHex({ mode: "rgb", r, g, b });

describe.each(THEMES)("over the field of the %s theme", (theme) => {
  const tokens = tokensOf(theme);
  const shown = (hex: string) =>
    hexOf(mix(parsed(tokens["scene"]), parsed(hex), Number(tokens["field-opacity"])));

  test.each(["anchor", "ink", "truth"])(
    "%s can be seen at every number and where no bound exists",
    (token) => {
      for (const ground of [...FIELD_STOPS, tokens["no-bound"]])
        expect(wcagContrast(tokens[token], shown(ground)), ground).toBeGreaterThanOrEqual(3);
    },
  );

  test("hatching can be seen on the larger half of the numbers and where no bound exists", () => {
    for (const ground of [...FIELD_STOPS.slice(8), tokens["no-bound"]])
      expect(wcagContrast(shown(tokens["hatch"]), shown(ground)), ground).toBeGreaterThanOrEqual(2);
  });
});

test("colours between the stops, and those of the ends beyond them", () => {
  const colours = {
    stops: [
      [0, 0, 0],
      [1, 0.5, 0],
      [1, 1, 1],
    ] as Rgb[],
  };
  expect(colourAt(colours, 0.25)).toEqual([0.5, 0.25, 0]);
  expect(colourAt(colours, 0.5)).toEqual([1, 0.5, 0]);
  expect(colourAt(colours, -3)).toEqual([0, 0, 0]);
  expect(colourAt(colours, 7)).toEqual([1, 1, 1]);
});
