import { expect, test } from "vitest";
import type { MotionRecord } from "../../generated/MotionRecord";
import { length } from "../../scene/geometry";
import { motionOf, turned } from "./motion";

const mode = (standard_deviation: number | null): MotionRecord => ({
  rotation: [0, 0, 0],
  shift: [0, 0, 1],
  standard_deviation,
  turning: 0,
});

test("a motion that can be seen is drawn by one standard deviation", () => {
  expect(motionOf(mode(0.3), 0.5, 10)).toMatchObject({ shift: [0, 0, 0.3], times: 1 });
});

test("a small one is drawn larger by a round number, an unseen one by a part of the body", () => {
  const { shift, times } = motionOf(mode(0.001), 0.5, 10);
  expect(times).toBe(200);
  expect(shift[2]).toBeCloseTo(0.2, 12);
  expect(motionOf(mode(null), 0.5, 10)).toMatchObject({ shift: [0, 0, 0.3], times: null });
});

test("none leaves the scene", () => {
  expect(length(motionOf(mode(1e6), 0.5, 10).shift)).toBeCloseTo(10, 9);
});

test("a quarter turn about z takes x to y and keeps z", () => {
  const at = turned([1, 0, 2], [0, 0, Math.PI / 2]);
  [0, 1, 2].forEach((value, axis) => expect(at[axis]).toBeCloseTo(value, 12));
});
