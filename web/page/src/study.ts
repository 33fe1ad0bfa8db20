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
  /** Mean NIS over its degrees of freedom: 1 where ranges come as far off as was expected. */
  readonly nis: Curve;
  /** Mean over the trials, a number a step. */
  readonly nisDegreesOfFreedom: Float64Array;
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

/** A figure where a run begins, over all of it, and where it ends; a number a threshold. */
export interface AlongRun {
  readonly first: Curve;
  readonly all: Curve;
  readonly last: Curve;
}

/** What projections of the ET-KF cost and give: a number a threshold, increasing. */
export interface BudgetCurves {
  readonly trials: number;
  readonly thresholds: Float64Array;
  /** Projections in a run. */
  readonly projections: Curve;
  /** Root mean square of `||Q_hat - Q||_F`. */
  readonly orientation: AlongRun;
  /** Root mean square rotation angle, rad. */
  readonly angle: AlongRun;
}

/** Root mean squares over one run: rad and metres, a number a draw; NaN where a run ended in an error. */
export interface RunErrors {
  readonly angle: Float64Array;
  readonly position: Float64Array;
}

/** The same trials with the scenario's own anchors and with those drawn anew. */
export interface Deviations {
  readonly fixed: RunErrors;
  readonly redrawn: RunErrors;
}

/** Anchors drawn anew, trial by trial. */
export interface AnchorDraws {
  readonly trials: number;
  /** Of the cube around the origin in which they are drawn, metres. */
  readonly halfWidth: number;
  /** Largest over least singular value of the centred anchors; NaN where they lie in a plane. */
  readonly fixedCondition: number;
  readonly conditions: Float64Array;
  /** The posterior bound on the rotations, the KF and the UC-KF. */
  readonly bound: Deviations;
  readonly filter: Deviations;
  readonly constrained: Deviations;
}
