import { beforeAll, describe, expect, test } from "vitest";
import { DEGREES_PER_RADIAN } from "../../controls/format";
import { explore, preset } from "../../engine";
import { loadEngineForTests } from "../../engine/testing";
import type { Scenario } from "../../scenario";
import { scaled, sizeOf } from "../../rigid-body/topologies";
import { sizeCurves, sizesAround } from "./size-curves";
import { sentence, sizeFor, sizePlot } from "./size-plot";

beforeAll(loadEngineForTests);

const plotOf = (scenario: Scenario) => sizePlot(sizeCurves(scenario), scenario.field.form);

describe("the sizes", () => {
  test("go over whole decades of the scene, with the body's own among them", () => {
    const sizes = sizesAround(0.3, 7, 12);
    expect([sizes[0], sizes[sizes.length - 1]].map((size) => Number(size.toPrecision(9)))).toEqual([
      0.01, 10,
    ]);
    expect([...sizes]).toContain(0.3);
    expect([...sizes]).toEqual([...sizes].sort((a, b) => a - b));
  });

  test("hold a body that is smaller or larger than the scene has need of", () => {
    expect(sizesAround(0.0004, 7, 12)[0]).toBeCloseTo(0.0001, 12);
    expect(sizesAround(300, 7, 12).at(-1)).toBeCloseTo(1000, 9);
    expect(sizesAround(0, 7, 12)).toHaveLength(37);
  });

  test("have the body's own once where it is one of them anyway", () => {
    const sizes = sizesAround(0.1, 7, 12);
    expect(sizes).toHaveLength(37);
    expect(new Set(sizes).size).toBe(37);
  });
});

describe("the curve", () => {
  test("is the bound of the body made that large", () => {
    const scenario = preset("room");
    const { x, lines } = plotOf(scenario);
    const [projected, raw] = lines;
    for (const [form, line] of [["projected", projected] as const, ["raw", raw] as const])
      for (const point of [0, 17, x.values.length - 1]) {
        const sensors = scaled(scenario.sensors, x.values[point]);
        const { angle_sigma } = explore({ ...scenario, sensors, field: { ...scenario.field, form } });
        const expected = (angle_sigma ?? NaN) * DEGREES_PER_RADIAN;
        // Sensors are written with nine digits.
        expect(Math.abs(line.values[point] / expected - 1)).toBeLessThan(1e-7);
      }
    expect(projected.values[20]).toBeGreaterThan(raw.values[20]);
  });

  test("marks the body as it is, whose bound is that of the read-out", () => {
    const scenario = preset("room");
    const { x, lines } = plotOf(scenario);
    expect(x.now).toBe(sizeOf(scenario.sensors));
    const line = lines.find(({ name }) => name === scenario.field.form);
    const own = line?.values[x.values.indexOf(x.now ?? 0)] ?? NaN;
    expect(own).toBeCloseTo((explore(scenario).angle_sigma ?? NaN) * DEGREES_PER_RADIAN, 9);
  });

  test("is empty with a reason for a rod and for a single sensor", () => {
    const scenario = preset("room");
    const rod = { ...scenario, sensors: [[-0.1, 0, 0], [0, 0, 0], [0.2, 0, 0]] }; // prettier-ignore
    expect(plotOf(rod).note).toBe("No size lets these sensors see every rotation.");
    const single = plotOf({ ...scenario, sensors: [[0.1, 0, 0]] });
    expect(single.note).toBe("A single sensor has no size.");
    expect(single.lines.every((line) => line.values.every(Number.isNaN))).toBe(true);
  });
});

describe("what is told of it", () => {
  const sizes = Float64Array.of(0.1, 1, 10);

  test("names the slope of small bodies and the size for one degree", () => {
    expect(sentence(sizes, Float64Array.of(20, 2, 0.2))).toBe(
      "Small bodies: slope −1 (∝\u00a01/size). 1\u00a0deg from 2.00\u00a0m.",
    );
  });

  test("says no inverse size of another slope, nor a size that is not there", () => {
    const told = sentence(sizes, Float64Array.of(200, 63.2, 40));
    expect(told).toBe("Small bodies: slope −0.5. 1 deg is not reached.");
  });

  test("finds a size between two points", () => {
    expect(sizeFor(1, sizes, Float64Array.of(40, 4, 0.25))).toBeCloseTo(10 ** 0.5, 9);
    expect(sizeFor(50, sizes, Float64Array.of(40, 4, 0.25))).toBe(0.1);
    expect(sizeFor(1, sizes, Float64Array.of(NaN, NaN, NaN))).toBeNull();
  });
});
