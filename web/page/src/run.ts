import type { Geometry } from "./generated/Geometry";

export type { Geometry } from "./generated/Geometry";

/** A tracking run as the page reads it: plain typed arrays, K steps, D dimensions, A = D(D-1)/2 rotation angles, M anchors, N sensors,
 * matrices row by row; NaN where there is no number. */
export interface PoseTrack {
  /** K x D x D. */
  readonly orientations: Float64Array;
  /** K x D, metres. */
  readonly positions: Float64Array;
}

export interface EstimatorRun extends PoseTrack {
  readonly name: string;
  readonly label: string;
  /** Geodesic angle, rad. */
  readonly orientationErrors: Float64Array;
  /** Metres. */
  readonly positionErrors: Float64Array;
  /** `||Q^T Q - I||_F` before any projection. */
  readonly defects: Float64Array;
  /** 1 where the estimate was projected. */
  readonly events: Uint8Array;
  /** Normalized estimation errors squared. */
  readonly nees: Float64Array;
  /** Their mean where the covariance is right; 0 where the truth is not known. */
  readonly neesDegreesOfFreedom: number;
  /** Normalized innovations squared. */
  readonly nis: Float64Array;
  /** Their mean where the filter expects what comes, a number a step: missing ranges lower it. */
  readonly nisDegreesOfFreedom: Uint32Array;
  /** K x D x D, square metres. */
  readonly positionCovariances: Float64Array;
  /** Of the error's rotation vector in the world frame: K x A x A, rad^2. It means something well below 1 rad^2. */
  readonly rotationCovariances: Float64Array;
  /** The step at which the estimator stopped, or null; from there on its values mean nothing. */
  readonly stopped: { step: number; sentence: string } | null;
}

export interface BoundRun {
  readonly name: string;
  readonly label: string;
  /** Root of the trace, rad. */
  readonly orientation: Float64Array;
  /** Root of the trace, metres. */
  readonly position: Float64Array;
  /** K x D x D, square metres. */
  readonly positionCovariances: Float64Array;
  /** Of the error's rotation vector in the world frame: K x A x A, rad^2. */
  readonly rotationCovariances: Float64Array;
}

export interface Run {
  readonly dimension: number;
  readonly steps: number;
  /** Seconds. */
  readonly times: Float64Array;
  /** The anchors used, M rows: presets that redraw anchors differ from the scenario here. */
  readonly anchors: number[][];
  /** How anchors and sensors lie, and what that hides; lengths in metres. */
  readonly geometry: Geometry;
  /** 1 where the range was measured: K x M x N. */
  readonly present: Uint8Array;
  readonly truth: PoseTrack;
  readonly estimators: EstimatorRun[];
  readonly bounds: BoundRun[];
}

/** Row `step` of K x D numbers, as a 3-vector; a planar point lies at height 0. */
export function pointAt(values: Float64Array, step: number, dimension: number): [number, number, number] {
  const at = step * dimension;
  return [values[at], values[at + 1], dimension === 3 ? values[at + 2] : 0];
}

/** Matrix `step` of K x D x D numbers as 3 x 3 rows; a planar matrix gets `corner` at the lower right. */
export function matrixAt(values: Float64Array, step: number, dimension: number, corner: number): number[][] {
  const at = step * dimension * dimension;
  if (dimension === 3) return [0, 3, 6].map((row) => [...values.subarray(at + row, at + row + 3)]);
  return [
    [values[at], values[at + 1], 0],
    [values[at + 2], values[at + 3], 0],
    [0, 0, corner],
  ];
}

/** Whether the estimator still ran at `step`. */
export function runsAt(estimator: Pick<EstimatorRun, "stopped">, step: number): boolean {
  return estimator.stopped === null || step < estimator.stopped.step;
}
