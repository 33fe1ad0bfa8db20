import { beforeAll, describe, expect, test } from "vitest";
import { figureBlock, figureJobs, figures, FigureSum } from "../engine";
import { loadEngineForTests } from "../engine/testing";
import type { FigurePicture } from "../figure";
import type { Verdict } from "../generated/Verdict";
import type { Palette } from "../theme/palette";
import { foundWords, targetWords } from "./claims";
import { figureSvg } from "./files";
import { keyOf, plotsOf } from "./panels";

const palette = { css: (token: string) => (token === "font" ? '"A", serif' : "#123456") } as Palette;

function computed(name: string, trials: number): FigurePicture {
  const order = { name, trials, seed: 3 };
  const sum = new FigureSum(order);
  for (let job = 0; job < figureJobs(order); job++) sum.push(figureBlock(order, job));
  return sum.read();
}

beforeAll(loadEngineForTests);

describe("every figure", () => {
  test("has plots whose curves differ by name and by look", { timeout: 60_000 }, () => {
    for (const { name } of figures()) {
      const { report } = computed(name, 2);
      for (const { lines, x } of plotsOf(report)) {
        expect(new Set(lines.map((line) => line.name)).size, name).toBe(lines.length);
        const looks = lines.map(({ token, mark, dash }) => [token, mark, dash].join(" "));
        expect(new Set(looks).size, `${name}: ${looks.join("; ")}`).toBe(lines.length);
        expect([...x.values]).toEqual([...x.values].toSorted((a, b) => a - b));
        for (const line of lines)
          expect(line.values.some(Number.isFinite), `${name}, ${line.name}`).toBe(true);
      }
    }
  });

  test("has units with raised exponents", () => {
    const specs = plotsOf(computed("kinematics-1", 2).report);
    expect(specs.map(({ unit }) => unit)).toEqual(["m²", "m²/s", "m²/s²"]);
  });

  test("has shares that end at 1, and no other axis that does", () => {
    const ceilings = (name: string) =>
      plotsOf(computed(name, 2).report).map(({ ceiling }) => ceiling ?? null);
    expect(ceilings("indoor-9")).toEqual([1, 1, 1, 1]);
    expect(ceilings("kinematics-1")).toEqual([null, null, null]);
  });

  test("is drawn with command, scenarios and claims inside", () => {
    const { report } = computed("localization-6", 4);
    const specs = plotsOf(report);
    const { svg } = figureSvg(report, { specs, scaleOf: (spec) => spec.scale, palette });
    expect(svg).toContain("rangelab figure localization-6 --trials 4 --seed 3");
    expect(svg).toContain("&quot;sensors&quot;");
    for (const { label } of keyOf(specs)) expect(svg).toContain(`>${label}<`);
    expect(svg).not.toMatch(/NaN|Infinity|undefined/);
  });
});

test("numbers never speak against their verdict", () => {
  const words = (value: number, standard_error: number, verdict: Verdict) =>
    foundWords({ found: { value, standard_error }, target: { least: null, most: 1 }, verdict });
  expect(words(1.0000338, 6.1e-6, "does-not-hold")).toBe("1.0000338 ± 0.0000061");
  expect(words(1.0000338, 6.1e-5, "not-decided")).toBe("1.000034 ± 0.000061");
  expect(words(0.9999662, 6.1e-6, "holds")).toBe("1.000");
  expect(words(1.0000338, 0, "does-not-hold")).toBe("1.0000338");
});

test("numbers and targets read as on the command line", () => {
  const cases: readonly (readonly [number, number, string])[] = [
    [0.11596, 0.00213, "0.1160 ± 0.0021"],
    [0.11596, 0.000996, "0.1160 ± 0.0010"],
    [2, 0.25, "2.00 ± 0.25"],
    [12_345.6, 789, "12346 ± 789"],
    [0, 0, "0"],
    [0.0320149, 0, "0.03201"],
    [0.0320149, 4e-6, "0.03201"],
    [0.0320149, 6e-6, "0.0320149 ± 0.0000060"],
    [0, 0.1, "0.00 ± 0.10"],
    [3e-9, 4e-11, "3.00e−9 ± 4e−11"],
    [3e9, 4e5, "3.000e9"],
    [3e9, 4e7, "3.00e9 ± 4e7"],
  ];
  const anything = { target: { least: null, most: null }, verdict: "holds" } as const;
  for (const [value, standard_error, words] of cases)
    expect(foundWords({ found: { value, standard_error }, ...anything })).toBe(words);
  expect(foundWords({ found: null, ...anything })).toBe("no number");
  expect(targetWords({ least: 0.9, most: 1.1 })).toBe("0.9 to 1.1");
  expect(targetWords({ least: null, most: 1 })).toBe("at most 1");
  expect(targetWords({ least: 40, most: null })).toBe("at least 40");
});
