import { describe, expect, test } from "vitest";
import type { Run } from "../run";
import type { RangeNoise } from "../scenario";
import { medianRange, rangeDeviation, sameNoiseAs } from "./noise-level";

const run = {
  dimension: 2,
  steps: 2,
  anchors: [
    [3, 4],
    [0, 1],
    [0, -2],
  ],
  truth: { positions: new Float64Array([0, 0, 0, 0]) },
} as unknown as Run;

test("the median range is over all anchors and steps", () => {
  expect(medianRange(run)).toBe(2);
  expect(medianRange({ ...run, anchors: run.anchors.slice(1) })).toBe(1.5);
});

const NOISES: RangeNoise[] = [
  { kind: "range", sigma: 0.2 },
  { kind: "squared_range", sigma: 0.4 },
  { kind: "toa", zeta_db: 40 },
];

describe("a noise level in metres", () => {
  test("is what the definitions of the models say at 20 m", () => {
    for (const noise of NOISES) expect(rangeDeviation(noise, 20)).toBeCloseTo(0.2, 12);
  });

  test("stays when the model is changed", () => {
    for (const noise of NOISES)
      for (const { kind } of NOISES) {
        const other = sameNoiseAs(noise, kind, 20);
        expect(other.kind).toBe(kind);
        expect(rangeDeviation(other, 20)).toBeCloseTo(0.2, 3);
      }
  });
});
