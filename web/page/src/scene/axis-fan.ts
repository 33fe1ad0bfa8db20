import { add, cross, length, normalize, scale, type Vec3 } from "./geometry";

/** Radii that hold 95 % of the directions: of a normal distribution in two dimensions, and in one. */
const RADIUS_95 = { cone: 2.4477, sector: 1.96 };
/** Beyond a right angle nothing is known of a direction. */
const WIDEST = Math.PI / 2;
const CORNERS = 28;

/**
 * Directions around a unit `axis` that hold 95 % of where it points: the tip of the axis moves by w x axis for a small
 * rotation vector w, whose covariance (world frame, rad^2, rows of three; in the plane only its last entry) is given.
 * A closed ring in space, an arc in the plane. Null where the covariance says nothing.
 */
export function fanAround(
  axis: Vec3,
  covariance: readonly (readonly number[])[],
  planar: boolean,
): Vec3[] | null {
  if (planar) return sectorAround(axis, covariance[2][2]);
  const [first, second] = tangents(axis);
  // Of the tip along `first` and `second`: w x axis = w . (axis x first) along first.
  const [a, b] = [cross(axis, first), cross(axis, second)];
  const [aa, ab, bb] = [product(a, covariance, a), product(a, covariance, b), product(b, covariance, b)];
  const middle = (aa + bb) / 2;
  const spread = Math.hypot((aa - bb) / 2, ab);
  if (!(middle + spread > 0) || !Number.isFinite(middle)) return null;
  const turn = Math.atan2(2 * ab, aa - bb) / 2;
  const long = RADIUS_95.cone * Math.sqrt(middle + spread);
  const short = RADIUS_95.cone * Math.sqrt(Math.max(0, middle - spread));
  const major = add(scale(first, Math.cos(turn)), scale(second, Math.sin(turn)));
  const minor = add(scale(first, -Math.sin(turn)), scale(second, Math.cos(turn)));
  return Array.from({ length: CORNERS + 1 }, (_, i) => {
    const angle = (2 * Math.PI * i) / CORNERS;
    return turned(axis, add(scale(major, long * Math.cos(angle)), scale(minor, short * Math.sin(angle))));
  });
}

function sectorAround(axis: Vec3, variance: number): Vec3[] | null {
  if (!(variance > 0) || !Number.isFinite(variance)) return null;
  const half = Math.min(WIDEST, RADIUS_95.sector * Math.sqrt(variance));
  const across = cross([0, 0, 1], axis);
  const steps = CORNERS / 2;
  return Array.from({ length: steps + 1 }, (_, i) =>
    turned(axis, scale(across, half * ((2 * i) / steps - 1))),
  );
}

/** The axis turned towards a tangent by the angle that is its length. */
function turned(axis: Vec3, tangent: Vec3): Vec3 {
  const angle = Math.min(WIDEST, length(tangent));
  return add(scale(axis, Math.cos(angle)), scale(normalize(tangent), Math.sin(angle)));
}

/** Two unit vectors perpendicular to the axis and to each other. */
function tangents(axis: Vec3): [Vec3, Vec3] {
  const other: Vec3 = Math.abs(axis[2]) < 0.8 ? [0, 0, 1] : [1, 0, 0];
  const first = normalize(cross(axis, other));
  return [first, cross(axis, first)];
}

function product(a: Vec3, matrix: readonly (readonly number[])[], b: Vec3): number {
  return matrix.reduce((sum, row, i) => sum + a[i] * (row[0] * b[0] + row[1] * b[1] + row[2] * b[2]), 0);
}
