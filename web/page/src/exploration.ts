/** What the engine tells of one epoch of ranges: the bounds at a pose, the motions that are seen least, the field of bounds. */

export interface Exploration {
  /** Root of the trace of the bound on the position, m; null where there is none. */
  readonly position_sigma: number | null;
  /** The same of the orientation, rad. */
  readonly angle_sigma: number | null;
  /** m^2. */
  readonly position_covariance: number[][] | null;
  /** Of the rotation vector in the world frame, rad^2. */
  readonly rotation_covariance_in_world: number[][] | null;
  /** Motions of the body, the one seen least first. */
  readonly modes: readonly Mode[];
  /** Why the pose is not wholly seen, or seen badly; null where it is not so. */
  readonly cause: string | null;
  readonly sentence: string;
  /** Of the anchors less their centroid, m. */
  readonly anchor_singular_values: readonly number[];
  /** Of the sensors with a row of ones below them. */
  readonly sensor_singular_values: readonly number[];
  /** Another pose, or a mirrored body, that all ranges fit as well. */
  readonly twin: Twin | null;
  /** Whether the range from an anchor (row) to a sensor is there. */
  readonly available: readonly (readonly boolean[])[];
}

/** A small motion of the body, as long as one metre at the sensors. */
export interface Mode {
  /** Rotation vector in the body frame, rad; one angle in the plane. */
  readonly rotation: readonly number[];
  /** Shift in the world frame, m. */
  readonly shift: readonly number[];
  /** How far the body may be off along it, m at the sensors; null where it is not seen at all. */
  readonly standard_deviation: number | null;
  /** How much of it is turning, 0 to 1. */
  readonly turning: number;
}

export interface Twin {
  /** In the world frame, m. */
  readonly sensors: readonly (readonly number[])[];
  /** Whether it is a rotated body, not a mirrored one. */
  readonly proper: boolean;
  readonly sentence: string;
}

/** A rectangle of cells: the corner, and the edges along its rows and columns, m. */
export interface FieldLayout {
  readonly corner: readonly number[];
  readonly u: readonly number[];
  readonly v: readonly number[];
  readonly width: number;
  readonly height: number;
}

export type FieldProbe = Pick<
  Exploration,
  "position_sigma" | "angle_sigma" | "position_covariance" | "sentence"
>;
