import { describe, expect, test } from "vitest";
import { padFor, padFromWorld, simplified, worldFromPad } from "./drawing";

describe("a drawn line", () => {
  const circle = Array.from({ length: 500 }, (_, i) => [Math.cos(i / 80), Math.sin(i / 80)]);

  test("keeps its ends and no more points than asked for", () => {
    const few = simplified(circle, 12);
    expect(few).toHaveLength(12);
    expect([few[0], few[11]]).toEqual([circle[0], circle[499]]);
  });

  test("stays near what was drawn", () => {
    for (const [most, near] of [
      [12, 0.09],
      [60, 0.005],
    ]) {
      const few = simplified(circle, most);
      for (const point of circle) {
        const distances = few.slice(1).map((to, index) => distance(point, few[index], to));
        expect(Math.min(...distances)).toBeLessThan(near);
      }
    }
  });

  test("that is straight is two points", () => {
    const straight = Array.from({ length: 50 }, (_, i) => [i, 2 * i]);
    expect(simplified(straight, 60)).toEqual([
      [0, 0],
      [49, 98],
    ]);
  });

  /** By trying, unlike the page. */
  function distance(point: number[], from: readonly number[], to: readonly number[]): number {
    const shares = Array.from({ length: 41 }, (_, i) => i / 40);
    return Math.min(
      ...shares.map((share) =>
        Math.hypot(...point.map((value, axis) => value - from[axis] - share * (to[axis] - from[axis]))),
      ),
    );
  }
});

describe("the pad", () => {
  const corners = [
    [0, 0],
    [6, 5],
  ];
  const pad = padFor(corners, 300, 200);

  test("holds all points, x to the right and y up", () => {
    const [[left, bottom], [right, top]] = corners.map((corner) => padFromWorld(pad, corner));
    expect(left).toBeLessThan(right);
    expect(top).toBeLessThan(bottom);
    for (const value of [left, top]) expect(value).toBeGreaterThanOrEqual(20);
    expect(right).toBeLessThanOrEqual(280);
    expect(bottom).toBeLessThanOrEqual(180);
  });

  test("finds the point of the ground at a pixel again", () => {
    for (const pixel of [
      [0, 0],
      [150, 100],
      [280.5, 33],
    ]) {
      const again = padFromWorld(pad, worldFromPad(pad, pixel));
      expect(Math.hypot(again[0] - pixel[0], again[1] - pixel[1])).toBeLessThan(1);
    }
  });

  test("has a scale where all points are one", () => {
    expect(padFor([[3, 3]], 300, 200).scale).toBeGreaterThan(0);
  });
});
