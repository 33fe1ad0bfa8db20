import { cross, dot, length, normalize, sub, type Vec3 } from "./geometry";

/** The outline of a body: which of its points are joined, and the triangles of its faces. */
export interface Hull {
  readonly edges: readonly (readonly [number, number])[];
  readonly faces: readonly (readonly [number, number, number])[];
}

/** Trying all triples is cubic; bodies with more sensors are drawn as their sensors only. */
const MOST_POINTS = 32;

/**
 * Convex hull of a few points by trying every plane through three of them. An edge counts where two faces of
 * different direction meet, so that no diagonal of a flat face is drawn. Flat bodies become their flat outline.
 */
export function hullOf(points: readonly Vec3[]): Hull {
  if (points.length > MOST_POINTS) return { edges: [], faces: [] };
  const size = Math.max(1e-12, ...points.map(length));
  const normals = new Map<string, Vec3[]>();
  const faces: [number, number, number][] = [];
  for (const [i, j, k] of triples(points.length)) {
    const normal = supportingNormal(points, i, j, k, size);
    if (!normal) continue;
    faces.push([i, j, k]);
    for (const [a, b] of [
      [i, j],
      [j, k],
      [i, k],
    ]) {
      const key = `${a},${b}`;
      const known = normals.get(key) ?? [];
      if (!known.some((other) => dot(other, normal) > 0.999)) normals.set(key, [...known, normal]);
    }
  }
  const edges = [...normals].filter(([, list]) => list.length > 1).map(([key]) => pair(key));
  return faces.length > 0 && edges.length > 0
    ? { edges, faces }
    : { edges: flatOutline(points, size), faces: [] };
}

function pair(key: string): [number, number] {
  const [a, b] = key.split(",").map(Number);
  return [a, b];
}

function* triples(count: number): Generator<[number, number, number]> {
  for (let i = 0; i < count; i++)
    for (let j = i + 1; j < count; j++) for (let k = j + 1; k < count; k++) yield [i, j, k];
}

/** The outward normal of the plane through three points where all others lie on one side of it. */
function supportingNormal(
  points: readonly Vec3[],
  i: number,
  j: number,
  k: number,
  size: number,
): Vec3 | null {
  const raw = cross(sub(points[j], points[i]), sub(points[k], points[i]));
  if (length(raw) < 1e-9 * size * size) return null;
  const normal = normalize(raw);
  const heights = points.map((point) => dot(sub(point, points[i]), normal));
  const above = Math.max(...heights) > 1e-6 * size;
  const below = Math.min(...heights) < -1e-6 * size;
  if (above === below) return null;
  return above ? [-normal[0], -normal[1], -normal[2]] : normal;
}

/** Joins two points of a flat body where all others lie on one side of the line through them. */
function flatOutline(points: readonly Vec3[], size: number): [number, number][] {
  const plane = planeNormal(points, size);
  const edges: [number, number][] = [];
  for (let i = 0; i < points.length; i++) {
    for (let j = i + 1; j < points.length; j++) {
      const along = sub(points[j], points[i]);
      const sides = points.map((point) => dot(cross(along, sub(point, points[i])), plane) / (size * size));
      if (!(Math.max(...sides) > 1e-9 && Math.min(...sides) < -1e-9)) edges.push([i, j]);
    }
  }
  return edges;
}

function planeNormal(points: readonly Vec3[], size: number): Vec3 {
  for (const [i, j, k] of triples(points.length)) {
    const normal = cross(sub(points[j], points[i]), sub(points[k], points[i]));
    if (length(normal) > 1e-9 * size * size) return normalize(normal);
  }
  return [0, 0, 1];
}
