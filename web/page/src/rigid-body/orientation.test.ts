import { describe, expect, test } from "vitest";
import { anglesOf, defectOf, rotationOf } from "./orientation";

const determinant = ([a, b, c]: number[][]) =>
  a[0] * (b[1] * c[2] - b[2] * c[1]) -
  a[1] * (b[0] * c[2] - b[2] * c[0]) +
  a[2] * (b[0] * c[1] - b[1] * c[0]);

describe("roll, pitch and yaw", () => {
  test("come back from the rotation that they make", () => {
    for (const roll of [-170, -30, 0, 45, 180])
      for (const pitch of [-89, -20, 0, 60])
        for (const yaw of [-120, 0, 10, 179])
          anglesOf(rotationOf([roll, pitch, yaw])).forEach((angle, index) =>
            expect(angle).toBeCloseTo([roll, pitch, yaw][index], 8),
          );
  });

  test("make rotations, straight up and down too", () => {
    for (const angles of [
      [10, 20, 30],
      [0, 90, 0],
      [40, -90, 70],
      [180, 0, 90],
    ]) {
      const rotation = rotationOf(angles);
      expect(defectOf(rotation)).toBeLessThan(1e-15);
      expect(determinant(rotation)).toBeCloseTo(1, 14);
      const again = rotationOf(anglesOf(rotation));
      rotation.flat().forEach((entry, index) => expect(again.flat()[index]).toBeCloseTo(entry, 9));
    }
  });

  test("turn the right way: yaw takes x to y, pitch takes z to x, roll takes y to z", () => {
    const column = (angles: number[], index: number) => rotationOf(angles).map((row) => row[index]);
    expect(column([0, 0, 90], 0)).toEqual([0, 1, 0]);
    expect(column([0, 90, 0], 2)).toEqual([1, 0, 0]);
    expect(column([90, 0, 0], 1)).toEqual([0, 0, 1]);
  });
});

test("a heading in the plane turns x towards y", () => {
  expect(rotationOf([90]).map((row) => row[0])).toEqual([0, 1]);
  expect(anglesOf(rotationOf([-37]))[0]).toBeCloseTo(-37, 9);
});

test("the defect tells a rotation from another matrix", () => {
  expect(
    defectOf([
      [2, 0],
      [0, 1],
    ]),
  ).toBe(3);
});
