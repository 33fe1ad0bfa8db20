import { describe, expect, test } from "vitest";
import { ellipsoidAxes, principalAxes } from "./ellipsoid";
import { niceBelow, type Vec3 } from "./geometry";
import { hullOf } from "./hull";

describe("hullOf", () => {
  const pyramid: Vec3[] = [
    [1, 1, 0],
    [-1, 1, 0],
    [-1, -1, 0],
    [1, -1, 0],
    [0, 0, 2],
  ];

  test("a pyramid has eight edges and no diagonal", () => {
    const { edges } = hullOf(pyramid);
    expect(edges).toHaveLength(8);
    expect(edges).not.toContainEqual([0, 2]);
    expect(edges).not.toContainEqual([1, 3]);
  });

  test("a point inside joins nothing", () => {
    const { edges, faces } = hullOf([...pyramid, [0, 0, 0.5]]);
    expect([...edges, ...faces].flat()).not.toContain(5);
  });

  test("a flat body becomes its outline", () => {
    expect(hullOf(pyramid.slice(0, 4)).edges).toEqual([
      [0, 1],
      [0, 3],
      [1, 2],
      [2, 3],
    ]);
  });

  test("points on a line are joined", () => {
    expect(
      hullOf([
        [-1, 0, 0],
        [1, 0, 0],
      ]).edges,
    ).toEqual([[0, 1]]);
  });
});

describe("ellipsoids", () => {
  const covariance = [
    [4, 1, 0.5],
    [1, 3, -0.2],
    [0.5, -0.2, 2],
  ];

  test("principal axes rebuild the matrix", () => {
    const { values, vectors } = principalAxes(covariance);
    for (let i = 0; i < 3; i++)
      for (let j = 0; j < 3; j++) {
        const sum = values.reduce((total, value, k) => total + value * vectors[i][k] * vectors[j][k], 0);
        expect(sum).toBeCloseTo(covariance[i][j], 12);
      }
  });

  test("semi-axes of the second step hold 95 % and are as long as magnified", () => {
    const values = Float64Array.from([...new Array(9).fill(0), 4, 0, 0, 0, 1, 0, 0, 0, 0.25]);
    const axes = ellipsoidAxes(values, 1, 3, 10);
    const lengths = axes?.map((axis) => Math.hypot(...axis)).sort((a, b) => b - a);
    [2, 1, 0.5].forEach((root, i) => expect(lengths?.[i]).toBeCloseTo(27.955 * root, 6));
  });

  test("no ellipsoid for a covariance that is none", () => {
    expect(ellipsoidAxes(new Float64Array(9), 0, 3, 1)).toBeNull();
    expect(ellipsoidAxes(new Float64Array(9).fill(NaN), 0, 3, 1)).toBeNull();
  });
});

test("niceBelow gives 1, 2, 5 times a power of ten", () => {
  expect([0.3, 1, 4.9, 70, 1234].map(niceBelow).map((value) => Number(value.toPrecision(3)))).toEqual([
    0.2, 1, 2, 50, 1000,
  ]);
});
