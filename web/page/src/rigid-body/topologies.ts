import { topologies } from "../engine";
import type { NamedTopology } from "../scenario";

/** Bodies in other sizes than that in which they come. */

/** Largest distance between two sensors, m. */
export function sizeOf(sensors: readonly (readonly number[])[]): number {
  return Math.max(...sensors.flatMap((one) => sensors.map((other) => distance(one, other))));
}

/** The same body in another size. */
export function scaled(sensors: readonly (readonly number[])[], size: number): number[][] {
  const factor = size / sizeOf(sensors);
  return sensors.map((sensor) => sensor.map((value) => Number((value * factor).toPrecision(9)) + 0));
}

/** The body that these sensors make in whatever size; null where it is none of those with a name. */
export function topologyOf(sensors: readonly (readonly number[])[]): NamedTopology | null {
  const size = sizeOf(sensors);
  const fits = ({ sensors: shape }: NamedTopology) =>
    shape.length === sensors.length &&
    shape.every(
      (point, index) =>
        distance(
          point.map((value) => value * size),
          sensors[index],
        ) <
        1e-4 * size,
    );
  return topologies(sensors[0].length).find(fits) ?? null;
}

export function centroid(points: readonly (readonly number[])[]): number[] {
  return points[0].map((_, axis) => points.reduce((sum, point) => sum + point[axis], 0) / points.length);
}

function distance(one: readonly number[], other: readonly number[]): number {
  return Math.hypot(...one.map((value, axis) => value - other[axis]));
}
