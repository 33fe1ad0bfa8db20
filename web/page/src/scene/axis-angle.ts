import { length, normalize, type Vec3 } from "./geometry";

/** Axis (unit) and angle (rad, 0 to pi) of a rotation matrix, for telling it; near half a turn by its diagonal. */
export function axisAngle(rotation: readonly (readonly number[])[]): { axis: Vec3; angle: number } {
  const [[a, b, c], [d, e, f], [g, h, i]] = rotation;
  const twice: Vec3 = [h - f, c - g, d - b];
  const angle = Math.atan2(length(twice), a + e + i - 1);
  if (length(twice) > 1e-6) return { axis: normalize(twice), angle };
  if (angle < 1) return { axis: [0, 0, 1], angle };
  const squares = [a, e, i].map((value) => Math.max(0, (value + 1) / 2));
  const largest = squares.indexOf(Math.max(...squares));
  const column = [a, b, c, d, e, f, g, h, i].filter((_, index) => index % 3 === largest);
  const [x, y, z] = column.map((value, row) => value + (row === largest ? 1 : 0));
  return { axis: normalize([x, y, z]), angle };
}
