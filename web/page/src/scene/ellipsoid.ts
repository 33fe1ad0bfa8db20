import { matrixAt } from "../run";
import type { Vec3 } from "./geometry";

/** Root of the 95 % quantile of chi-square, by degrees of freedom: the ellipsoid that holds 95 % of the errors. */
const RADIUS_95 = { 2: 2.4477, 3: 2.7955 };

/**
 * Semi-axes of the 95 % ellipsoid of a position covariance (K x D x D numbers, square metres) at one step.
 * A planar one comes out as a thin disc. Null where the covariance is not positive.
 */
export function ellipsoidAxes(
  covariances: Float64Array,
  step: number,
  dimension: number,
  magnification: number,
): [Vec3, Vec3, Vec3] | null {
  const { values, vectors } = principalAxes(matrixAt(covariances, step, dimension, 0));
  const largest = Math.max(...values);
  if (!(largest > 0) || !Number.isFinite(largest)) return null;
  const radius = RADIUS_95[dimension === 2 ? 2 : 3] * magnification;
  const thinnest = 1e-4 * largest;
  const axis = (index: number): Vec3 => {
    const size = radius * Math.sqrt(Math.max(values[index], thinnest));
    return [vectors[0][index] * size, vectors[1][index] * size, vectors[2][index] * size];
  };
  return [axis(0), axis(1), axis(2)];
}

/** Eigenvalues and eigenvectors (as columns) of a symmetric 3 x 3 matrix by Jacobi rotations. */
export function principalAxes(symmetric: number[][]): { values: number[]; vectors: number[][] } {
  const a = symmetric.map((row) => [...row]);
  const vectors = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  for (let sweep = 0; sweep < 12; sweep++) {
    for (const [p, q] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ])
      rotate(a, vectors, p, q);
  }
  return { values: [a[0][0], a[1][1], a[2][2]], vectors };
}

function rotate(a: number[][], vectors: number[][], p: number, q: number): void {
  if (Math.abs(a[p][q]) < 1e-300) return;
  const theta = 0.5 * Math.atan2(2 * a[p][q], a[p][p] - a[q][q]);
  const c = Math.cos(theta);
  const s = Math.sin(theta);
  for (let i = 0; i < 3; i++) [a[i][p], a[i][q]] = [c * a[i][p] + s * a[i][q], c * a[i][q] - s * a[i][p]];
  for (let i = 0; i < 3; i++) [a[p][i], a[q][i]] = [c * a[p][i] + s * a[q][i], c * a[q][i] - s * a[p][i]];
  for (const row of vectors) [row[p], row[q]] = [c * row[p] + s * row[q], c * row[q] - s * row[p]];
}
