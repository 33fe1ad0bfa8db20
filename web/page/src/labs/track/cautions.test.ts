import { describe, expect, test } from "vitest";
import type { Run } from "../../run";
import type { Scenario } from "../../scenario";
import {
  onDecoupling,
  onFeedback,
  onLinearBound,
  onManifold,
  onPrior,
  onProcessNoise,
  onThreshold,
  onWeighting,
  onWeights,
  trueProcessNoise,
} from "./cautions";

const scenario = {
  dimension: 2,
  sensors: [
    [-1, 0],
    [1, 0],
  ],
  weights: "measured",
  weighting: "common",
  interval: 0.5,
  motion: { sigma_omega: 0.2, sigma_t: 0.03 },
  process: { sigma_q: 0.1, sigma_t: 0.03 },
  start: { position: [3, 4] },
  initial: { position: [0, 0], covariance: 4 },
  estimators: {
    manifold: "so",
    feedback: false,
    decoupled: false,
    threshold: { kind: "absolute", epsilon: 0.1 },
  },
} as unknown as Scenario;
const settings = scenario.estimators;
const with_ = (part: Partial<Scenario["estimators"]>): Scenario => ({
  ...scenario,
  estimators: { ...settings, ...part },
});

test("the usual choices are no reason for a warning", () => {
  for (const say of [onManifold, onFeedback, onDecoupling, onWeights, onThreshold, onPrior, onProcessNoise])
    expect(say(scenario).warning, say.name).toBe(false);
});

test("each dangerous choice is warned of", () => {
  expect(onManifold(with_({ manifold: "o" })).text).toContain("mirrored");
  expect(onFeedback(with_({ feedback: true })).text).toContain("NEES");
  expect(onWeights({ ...scenario, weights: "true" }).text).toContain("cheating");
  expect(onThreshold(with_({ threshold: { kind: "relative", epsilon: 1 } })).warning).toBe(true);
});

describe("decoupling", () => {
  test("is exact for centred sensors", () => {
    expect(onDecoupling(with_({ decoupled: true })).warning).toBe(false);
  });

  test("says by how much they are off centre", () => {
    const shifted = {
      ...with_({ decoupled: true }),
      sensors: [
        [-1, 0.3],
        [1, 0.3],
      ],
    };
    expect(onDecoupling(shifted)).toMatchObject({ warning: true, text: expect.stringContaining("0.300 m") });
  });
});

test("common weights are warned of where the body is large beside the ranges", () => {
  expect(onWeighting(scenario, 100).warning).toBe(false);
  expect(onWeighting(scenario, 100).text).toContain("1.00 %");
  expect(onWeighting(scenario, 2).warning).toBe(true);
  expect(onWeighting({ ...scenario, weighting: "per_pair" }, 2).warning).toBe(false);
});

describe("process noise", () => {
  const assuming = (sigma_q: number, sigma_t: number) =>
    onProcessNoise({ ...scenario, process: { sigma_q, sigma_t } }).text;

  test("is compared with what disturbs the body in one step", () => {
    expect(assuming(0.01, 0.03)).toBe(
      "Orientation: 10.0 times too little, so the filters trust their prediction and lag.",
    );
    expect(assuming(0.1, 0.6)).toContain("Position: 20.0 times too much");
    expect(assuming(0, 0)).toMatch(/Orientation: none assumed.*Position: none assumed/);
  });

  test("that matches the truth is not warned of", () => {
    expect(onProcessNoise({ ...scenario, process: trueProcessNoise(scenario) }).warning).toBe(false);
    const still = { ...scenario, motion: { ...scenario.motion, sigma_omega: 0, sigma_t: 0 } };
    expect(onProcessNoise({ ...still, process: trueProcessNoise(still) }).warning).toBe(false);
    expect(onProcessNoise(still).text).toContain("some assumed where there is none");
  });
});

describe("the prior", () => {
  const believing = (covariance: number) =>
    onPrior({ ...scenario, initial: { ...scenario.initial, covariance } });

  test("is told as standard deviations", () => {
    expect(believing(4).text).toContain("± 2.00 m");
    expect(believing(4).text).toContain("± 81.0°");
  });

  test("is warned of where it is wide, and where the truth is far outside", () => {
    expect(believing(100).text).toContain("linearize");
    expect(believing(0.01).text).toContain("starts 5.00 m away");
  });
});

describe("the linear bound", () => {
  const bounds = (linear: number, intrinsic: number) =>
    ({
      bounds: [
        { name: "linear_posterior_crb", orientation: Float64Array.of(9, linear) },
        { name: "posterior_crb", orientation: Float64Array.of(9, intrinsic) },
      ],
    }) as unknown as Run;

  test("is told to lie below or above the intrinsic one, with both at the step", () => {
    expect(onLinearBound(bounds(0.01, 0.02), 1)?.text).toMatch(
      /0\.573°, lies below the intrinsic one, 1\.15°/,
    );
    expect(onLinearBound(bounds(0.02, 0.01), 1)?.text).toMatch(
      /1\.15°, lies above the intrinsic one, 0\.573°/,
    );
  });

  test("is not compared where one of them does not exist", () => {
    expect(onLinearBound(bounds(0.01, NaN), 1)).toBeNull();
    expect(onLinearBound({ ...bounds(1, 1), bounds: [] }, 1)).toBeNull();
  });
});
