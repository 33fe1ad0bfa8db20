import { describe, expect, test } from "vitest";
import { fanAround } from "./axis-fan";
import { cross, dot, length, normalize, type Vec3 } from "./geometry";

const diagonal = (x: number, y: number, z: number) => [
  [x, 0, 0],
  [0, y, 0],
  [0, 0, z],
];
const angleTo = (axis: Vec3) => (direction: Vec3) =>
  Math.atan2(length(cross(axis, direction)), dot(axis, direction));

describe("fans of an axis", () => {
  test("a turn about the axis itself moves its tip nowhere", () => {
    const ring = fanAround([0, 0, 1], diagonal(1e-30, 1e-30, 0.04), false)!;
    expect(Math.max(...ring.map(angleTo([0, 0, 1])))).toBeLessThan(1e-12);
  });

  test("turns about x move the tip of z along y, 2.4477 sigma to either side", () => {
    const ring = fanAround([0, 0, 1], diagonal(0.01 ** 2, 0, 0), false)!;
    expect(Math.max(...ring.map(angleTo([0, 0, 1])))).toBeCloseTo(0.024477, 6);
    ring.forEach(([x]) => expect(x).toBeCloseTo(0, 12));
    expect(Math.max(...ring.map(([, y]) => y))).toBeCloseTo(Math.sin(0.024477), 6);
  });

  test("a correlated covariance gives the same ring as its samples' spread", () => {
    const covariance = [
      [4e-4, 1e-4, -2e-5],
      [1e-4, 1e-4, 3e-5],
      [-2e-5, 3e-5, 9e-4],
    ];
    const axis = normalize([1, -2, 0.5]);
    const ring = fanAround(axis, covariance, false)!;
    // The variance of the tip along a direction d is (axis x d)' P (axis x d); the ring's extent is 2.4477 roots of it.
    for (const d of [normalize(cross(axis, [0, 0, 1])), normalize(cross(axis, [0.3, 1, 0.2]))]) {
      const w = cross(axis, d);
      const variance = covariance.reduce((sum, row, i) => sum + w[i] * dot(row as unknown as Vec3, w), 0);
      const extent = Math.max(...ring.map((direction) => dot(direction, d)));
      expect(extent / (2.4477 * Math.sqrt(variance))).toBeCloseTo(1, 2);
    }
    ring.forEach((direction) => expect(length(direction)).toBeCloseTo(1, 12));
  });

  test("in the plane it is an arc of 1.96 sigma to either side, never wider than half a turn", () => {
    const arc = fanAround([1, 0, 0], diagonal(0, 0, 0.05 ** 2), true)!;
    expect(Math.atan2(arc[0][1], arc[0][0])).toBeCloseTo(-0.098, 9);
    expect(Math.atan2(arc.at(-1)![1], arc.at(-1)![0])).toBeCloseTo(0.098, 9);
    const widest = fanAround([1, 0, 0], diagonal(0, 0, 1e6), true)!;
    expect(Math.max(...widest.map(angleTo([1, 0, 0])))).toBeCloseTo(Math.PI / 2, 9);
  });

  test("no fan where there is no covariance", () => {
    expect(fanAround([1, 0, 0], diagonal(NaN, NaN, NaN), false)).toBeNull();
    expect(fanAround([1, 0, 0], diagonal(NaN, NaN, NaN), true)).toBeNull();
    expect(fanAround([1, 0, 0], diagonal(0, 0, 0), false)).toBeNull();
  });
});
