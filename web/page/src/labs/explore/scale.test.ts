import { describe, expect, test } from "vitest";
import { scaleOf, SteadyScale } from "./scale";

test("the scale has round ends around the bounds, and none of the places without one", () => {
  const values = Float32Array.from({ length: 100 }, (_, index) => 0.013 + 0.001 * index);
  const ends = scaleOf(values, 1);
  expect([ends.low, ends.high].map((end) => Number(end.toPrecision(6)))).toEqual([0.012, 0.12]);
  expect(scaleOf(Float32Array.of(...values, 1e30, 3e30), 1)).toEqual(ends);
});

test("angles are round in degrees", () => {
  const { low, high } = scaleOf(Float32Array.of(0.02, 0.03, 0.05), 180 / Math.PI);
  expect([low, high].map((end) => Number(((end * 180) / Math.PI).toPrecision(6)))).toEqual([1, 2]);
});

test("a field without any bound, and one of a single value, still have a scale", () => {
  const { low, high } = scaleOf(Float32Array.of(1e30, 1e30), 1);
  expect(high).toBeGreaterThan(low);
  const single = scaleOf(Float32Array.of(0.2), 1);
  expect(single.high).toBeGreaterThan(single.low);
  expect(single.low).toBeGreaterThan(0);
});

/** A thousand bounds, evenly spread over the logarithm. */
const spread = (least: number, most: number) =>
  Float32Array.from({ length: 1000 }, (_, index) => least * (most / least) ** (index / 999));

const round = (values: Float32Array) => scaleOf(values, 1);

describe("a steady scale", () => {
  test("keeps its ends while the values wander over a round number, where a fresh one jumps", () => {
    const steady = new SteadyScale();
    const drag = Array.from({ length: 60 }, (_, step) => {
      const wander = 1 + 0.1 * Math.sin(step / 3);
      return spread(0.02 * wander, 0.2 * wander);
    });
    const differing = (ends: { low: number; high: number }[]) =>
      new Set(ends.map(({ low, high }) => `${low} ${high}`)).size;
    expect(differing(drag.map((values) => scaleOf(values, 1)))).toBeGreaterThan(1);
    expect(differing(drag.map((values) => steady.ends("a", values, round)))).toBe(1);
  });

  test.each([
    ["run out of it at the low end", spread(0.005, 0.15)],
    ["run out of it at the high end", spread(0.03, 1)],
    ["take little of it", spread(0.05, 0.08)],
  ])("gives way where the values %s", (_what, values) => {
    const steady = new SteadyScale();
    steady.ends("a", spread(0.021, 0.19), round);
    expect(steady.ends("a", values, round)).toEqual(scaleOf(values, 1));
  });

  test("is for one kind of values", () => {
    const steady = new SteadyScale();
    const [wide, narrow] = [spread(0.021, 0.19), spread(0.023, 0.095)];
    expect(steady.ends("a", narrow, round)).not.toEqual(steady.ends("b", wide, round));
    expect(steady.ends("b", narrow, round)).toEqual(scaleOf(wide, 1));
    expect(steady.ends("c", narrow, round)).toEqual(scaleOf(narrow, 1));
  });

  test("stays where no bound is left", () => {
    const steady = new SteadyScale();
    const ends = steady.ends("a", spread(0.021, 0.19), round);
    expect(steady.ends("a", Float32Array.of(1e30), round)).toEqual(ends);
  });
});
