/** A Monte-Carlo study as the page reads it: one number a step, NaN where no trial reached it. */
export interface Curve {
  readonly value: Float64Array;
  /** One standard deviation of the value's sampling error. */
  readonly standardError: Float64Array;
}

export interface EstimatorCurves {
  readonly name: string;
  readonly label: string;
  /** Root mean square geodesic angle, rad. */
  readonly angle: Curve;
  /** Root mean square error of the position, m. */
  readonly position: Curve;
  /** Mean NEES over its degrees of freedom: 1 where the covariance is right. */
  readonly nees: Curve;
  readonly neesDegreesOfFreedom: number;
  /** Share of the trials in which the estimate was projected. */
  readonly eventRate: Curve;
  /** Trials in which the estimator had stopped by then. */
  readonly failures: Uint32Array;
}

/** The root of the mean bound; its standard error comes from the trajectories, which differ from trial to trial. */
export interface BoundCurves {
  readonly name: string;
  readonly label: string;
  readonly angle: Curve;
  readonly position: Curve;
}

export interface StudyCurves {
  readonly trials: number;
  readonly estimators: EstimatorCurves[];
  readonly bounds: BoundCurves[];
}
