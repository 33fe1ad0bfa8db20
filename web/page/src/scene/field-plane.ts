import type { FieldPicture } from "./field";
import { cross, dot, length, scale, type Vec3 } from "./geometry";
import type { View } from "./view";

/** Below this share of what it could be, the rectangle is seen edge-on. */
const EDGE_ON = 1e-9;

/**
 * The way back from a pixel (x, y) to the place (s, t) of the field's rectangle that is seen there: the rows of the matrix
 * that takes (x, y, 1) to (s w, t w, w), w > 0 in front of the viewer. Null where the rectangle is seen edge-on.
 */
export function fieldFromPixel(view: View, { corner, u, v }: FieldPicture): [Vec3, Vec3, Vec3] | null {
  const m = view.matrix;
  const { width, height } = view.viewport;
  // Homogeneous pixels of a point (`one` = 1) or a direction (0).
  const seen = ([x, y, z]: Vec3, one: number): Vec3 => {
    const row = (r: number) => m[r] * x + m[r + 4] * y + m[r + 8] * z + m[r + 12] * one;
    return [((row(0) + row(3)) / 2) * width, ((row(3) - row(1)) / 2) * height, row(3)];
  };
  const [a, b, c] = [seen(u, 0), seen(v, 0), seen(corner, 1)];
  const determinant = dot(a, cross(b, c));
  if (!(Math.abs(determinant) > EDGE_ON * length(a) * length(b) * length(c))) return null;
  const inverse = (row: Vec3) => scale(row, 1 / determinant);
  return [inverse(cross(b, c)), inverse(cross(c, a)), inverse(cross(a, b))];
}
