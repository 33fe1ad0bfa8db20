import { formatNumber } from "../../controls/format";
import { matrixAt } from "../../run";
import { principalAxes } from "../../scene/ellipsoid";

/** In which directions a position is known well and badly. */

/** How much of a direction must lie along an axis to be called by its name: within 15 degrees of it. */
const ALIGNED = 0.966;
/** Below this ratio nobody would call a direction weak. */
const TELLING = 3;

export interface WeakDirection {
  /** "Height", "x", or "Position along (0.71, 0, 0.71)". */
  readonly name: string;
  readonly direction: readonly number[];
  /** Standard deviation along it, and the root mean square of those across it, m. */
  readonly along: number;
  readonly across: number;
}

/** The one direction in which the position is known clearly worse than across it; null where there is none. */
export function weakDirection(
  covariances: Float64Array,
  step: number,
  dimension: number,
): WeakDirection | null {
  const { values, vectors } = principalAxes(matrixAt(covariances, step, dimension, 0));
  const axes = values
    .map((value, index) => ({ variance: value, direction: vectors.map((row) => row[index]) }))
    .filter(({ direction }) => dimension === 3 || direction[2] === 0)
    .sort((one, other) => other.variance - one.variance);
  const [weak, ...others] = axes;
  const across = Math.sqrt(others.reduce((sum, { variance }) => sum + variance, 0) / others.length);
  const along = Math.sqrt(weak.variance);
  if (!(across > 0) || !(along / across >= TELLING) || !Number.isFinite(along)) return null;
  const direction = weak.direction.slice(0, dimension);
  return { name: nameOf(direction), direction, along, across };
}

function nameOf(direction: readonly number[]): string {
  const axis = direction.findIndex((part) => Math.abs(part) > ALIGNED);
  if (axis >= 0) return ["x", "y", "height"][axis];
  const sign = Math.sign(direction.findLast((part) => part !== 0) ?? 1);
  return `position along (${direction.map((part) => formatNumber(Math.round(10 * sign * part) / 10 + 0)).join(", ")})`;
}
