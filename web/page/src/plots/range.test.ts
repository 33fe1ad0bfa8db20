import { describe, expect, test } from "vitest";
import { valueRange } from "./range";
import { type PlotAxis, type PlotLine, type Threshold, timeAxis } from "./spec";

const line = (values: number[], standardErrors: number[] | null = null): PlotLine => ({
  name: "kf",
  label: "KF",
  token: "kf",
  mark: null,
  dash: [],
  values: Float64Array.from(values),
  standardErrors: standardErrors && Float64Array.from(standardErrors),
  events: [],
});
const spec = (...values: number[]) => ({
  x: timeAxis(Float64Array.of(0, 1)),
  lines: [line(values)],
  bands: [],
  threshold: null,
});
const threshold = (...heights: number[]) => ({ heights: Float64Array.from(heights) }) as unknown as Threshold;

describe("a logarithmic axis", () => {
  test("ends on 1, 2, 5 and holds the data", () => {
    expect(valueRange(spec(0.013, 0.3), "log")).toEqual([0.01, 0.5]);
  });

  test("does not move with a small change of the data", () => {
    expect(valueRange(spec(0.0131, 0.31), "log")).toEqual(valueRange(spec(0.0139, 0.33), "log"));
  });

  test("shows at most three decades below the largest value", () => {
    expect(valueRange(spec(1e-9, 0.9), "log")).toEqual([0.0005, 1]);
  });

  test("cuts nothing off along anything but time", () => {
    const size: PlotAxis = { ...spec(1).x, name: "size", now: 1 };
    expect(valueRange({ ...spec(1e-5, 0.9), x: size }, "log")).toEqual([1e-5, 1]);
  });

  test("holds threshold, band and the errors of averages", () => {
    expect(valueRange({ ...spec(0.02), threshold: threshold(0.7) }, "log")[1]).toBe(1);
    expect(valueRange({ ...spec(1), bands: [{ low: 0.3, high: 1.9, label: "" }] }, "log")).toEqual([0.2, 2]);
    expect(valueRange({ ...spec(1), lines: [line([1], [0.7])] }, "log")[1]).toBe(5);
  });

  test("exists where nothing is positive", () => {
    expect(valueRange(spec(0, NaN, Infinity), "log")).toEqual([0.1, 1]);
  });
});

describe("a linear axis", () => {
  test("goes from zero to a round number", () => {
    expect(valueRange(spec(0.013, 0.33), "linear")).toEqual([0, 0.4]);
    expect(valueRange(spec(1), "linear")).toEqual([0, 1]);
    expect(valueRange(spec(0, NaN), "linear")).toEqual([0, 1]);
  });
});
