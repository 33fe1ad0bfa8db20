import { expect, test } from "vitest";
import { axisAngle } from "./axis-angle";
import { cross, dot, normalize, scale, sub, add, type Vec3 } from "./geometry";

/** Rodrigues: what turning about an axis does to the unit vectors, as columns. */
function rotation(axis: Vec3, angle: number): number[][] {
  const turned = (v: Vec3) =>
    add(
      add(scale(v, Math.cos(angle)), scale(cross(axis, v), Math.sin(angle))),
      scale(axis, dot(axis, v) * (1 - Math.cos(angle))),
    );
  const columns = [turned([1, 0, 0]), turned([0, 1, 0]), turned([0, 0, 1])];
  return [0, 1, 2].map((row) => columns.map((column) => column[row]));
}

test.each([0.1, 1.3, 3, Math.PI])("finds axis and angle of a turn by %d rad", (turn) => {
  const about = normalize([1, -2, 0.5]);
  const { axis, angle } = axisAngle(rotation(about, turn));
  expect(angle).toBeCloseTo(turn, 6);
  const difference = sub(axis, scale(about, Math.sign(dot(axis, about))));
  expect(Math.hypot(...difference)).toBeLessThan(1e-6);
  if (turn < 3.1) expect(dot(axis, about)).toBeCloseTo(1, 9);
});

test("no turn is no turn", () => {
  expect(axisAngle(rotation([1, 0, 0], 0)).angle).toBe(0);
});
