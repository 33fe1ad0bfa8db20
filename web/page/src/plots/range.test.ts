import { expect, test } from "vitest";
import { logRange } from "./range";

const spec = (...values: (number | null)[]) => ({
  lines: [{ name: "kf", label: "KF", token: "kf", mark: null, dash: [], events: [], values }],
  threshold: null,
});

test("ends lie on 1, 2, 5 and hold the data", () => {
  expect(logRange(spec(0.013, 0.3))).toEqual([0.01, 0.5]);
});

test("a small change of the data does not move the axis", () => {
  expect(logRange(spec(0.0131, 0.31))).toEqual(logRange(spec(0.0139, 0.33)));
});

test("at most three decades below the largest value are shown", () => {
  expect(logRange(spec(1e-9, 0.9))).toEqual([0.0005, 1]);
});

test("the threshold is inside", () => {
  expect(logRange({ ...spec(0.02), threshold: { value: 0.7, label: "" } })[1]).toBe(1);
});

test("nothing positive still gives an axis", () => {
  expect(logRange(spec(0, null, NaN))).toEqual([0.1, 1]);
});
