import type { Vec3 } from "./geometry";

/** Numbers of this size and larger mean that no bound exists there. */
export const UNBOUNDED = 1e30;

/**
 * Computes a field's numbers on a graphics device, over the same rectangle; the same object asks for the same numbers.
 * What it holds may be worked out when it is read: only a renderer that can compute does.
 */
export interface FieldProgram {
  /** Programs of one key have one text. */
  readonly key: string;
  /** WGSL, as the scene module's `set_field_kernel` takes it. */
  readonly text: string;
  readonly parameters: Float32Array;
  /** Cells along u and v. */
  readonly width: number;
  readonly height: number;
}

/**
 * A grid of positive numbers over a rectangle in space, shown by colours on a logarithmic scale. It never changes: another
 * field is another object, for renderers keep what they made of one.
 */
export interface FieldPicture {
  /** Row by row: `values[j * width + i]` is at `corner + (i + 0.5) / width * u + (j + 0.5) / height * v`. */
  readonly values: Float32Array;
  readonly width: number;
  readonly height: number;
  /** Metres, as both edges. */
  readonly corner: Vec3;
  readonly u: Vec3;
  readonly v: Vec3;
  /** Ends of the scale in the unit of the values: 0 < low < high. */
  readonly low: number;
  readonly high: number;
  /** Larger numbers are hatched; null: none are. */
  readonly worseThan: number | null;
  /** 0..1; `--field-opacity` leaves what is drawn over the field readable. */
  readonly opacity: number;
  /** What a renderer that can compute draws finer values by; null or left out: there are none. */
  readonly program?: FieldProgram | null;
}

/** Where a number is on the scale: 0 at its low end, 1 at its high end, beyond them outside 0..1. */
export function placeOnScale(value: number, { low, high }: Pick<FieldPicture, "low" | "high">): number {
  return Math.log(value / low) / Math.log(high / low);
}

/** The point of space at `(s, t)` of the rectangle, both 0..1. */
export function pointOfField({ corner, u, v }: FieldPicture, s: number, t: number): Vec3 {
  return [corner[0] + s * u[0] + t * v[0], corner[1] + s * u[1] + t * v[1], corner[2] + s * u[2] + t * v[2]];
}
