import type { KinematicsBounds } from "../../engine";
import type { KinematicsName } from "../../generated/KinematicsName";
import { asSentence } from "../../words";
import { type BoundKind, boundKinds, BOUNDS, estimatorOf, type KinematicsEstimator } from "./estimators";
import { levelsOfReport, levelsOfRun, type Level, overBound } from "./levels";
import type { AnchorlessRun } from "./run";
import type { StampAverages } from "./study";

/** A row of the table of errors. */
export interface Reading extends KinematicsEstimator {
  /** m, m/s, m/s²; null where the estimator finds no motion. */
  readonly errors: readonly number[] | null;
  /** Standard errors of these; null of one trial. */
  readonly standardErrors: readonly number[] | null;
  /** Times its bound in velocity. */
  readonly ratio: number | null;
  /** Why there is nothing in the row. */
  readonly remark: string;
}

/** The errors of one trial. */
export function runReadings(run: AnchorlessRun): Reading[] {
  const levels = levelsOfRun(run);
  return run.trial.estimators.map(({ name, failure, gram_errors }) => {
    const nothing = gram_errors.length > 0 ? "finds B, no motion" : "finds no motion, only each epoch";
    return reading(name, levels, failure === null ? nothing : asSentence(failure));
  });
}

/** The same on the average over trials. */
export function studyReadings(averages: StampAverages): Reading[] {
  const levels = levelsOfReport(averages, averages.bounds);
  return averages.estimators.map(({ name, summary: { failures } }) => {
    const remark = failures > 0 ? `nothing in ${failures} of ${averages.trials} trials` : "finds no motion";
    return reading(name, levels, remark);
  });
}

function reading(name: KinematicsName, levels: readonly Level[], remark: string): Reading {
  const level = levels.find((entry) => entry.name === name);
  return {
    ...estimatorOf(name),
    errors: level?.errors ?? null,
    standardErrors: level?.standardErrors ?? null,
    ratio: level ? overBound(level, 1) : null,
    remark: level ? "" : remark,
  };
}

export interface BoundReading {
  readonly kind: BoundKind;
  readonly label: string;
  readonly dash: readonly number[];
  readonly errors: readonly number[];
  readonly remark: string;
}

/** The bounds that belong to what is switched on. */
export function boundReadings(bounds: KinematicsBounds, enabled: readonly KinematicsName[]): BoundReading[] {
  return BOUNDS.filter(({ kind }) => boundKinds(enabled).includes(kind)).map(({ kind, label, dash }) => ({
    kind,
    label,
    dash,
    errors: bounds[kind].coefficients,
    remark: bounds[kind].failure === null ? "" : asSentence(bounds[kind].failure),
  }));
}
