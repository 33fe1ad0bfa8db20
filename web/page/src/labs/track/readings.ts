import { type Run, runsAt } from "../../run";
import type { Shape } from "../../scene/draw-list";
import { MARKS } from "../../theme/palette";
import { band } from "./findings/consistency";
import type { Curve, StudyCurves } from "../../study";
import { boundLook, shownBounds, shownOf } from "./plots";

/** A row of the table of errors: an estimator or a bound at one step, with the look that it has everywhere. */
export interface Reading {
  readonly name: string;
  readonly label: string;
  readonly token: string;
  readonly mark: Shape | null;
  readonly dash: readonly number[];
  /** Rad and metres; null where the estimator had stopped. */
  readonly errors: { readonly angle: number; readonly position: number } | null;
  /** What the row is, or why there is nothing in it. */
  readonly remark: string;
  readonly consistency: Consistency | null;
}

/** NEES over its degrees of freedom, 1 where the covariance is right, and where it stands to the band around that. */
export interface Consistency {
  readonly ratio: number;
  readonly verdict: "below" | "within" | "above";
}

export function estimatorReadings(run: Run, step: number): Reading[] {
  return run.estimators.map((estimator) => {
    const { name, label, stopped } = estimator;
    const look = estimatorLook(name, label);
    if (!runsAt(estimator, step)) {
      const remark = `stopped at step ${(stopped?.step ?? 0) + 1}: ${stopped?.sentence}`;
      return { ...look, errors: null, remark, consistency: null };
    }
    const errors = { angle: estimator.orientationErrors[step], position: estimator.positionErrors[step] };
    const [least, most] = band(estimator);
    const nees = estimator.nees[step];
    const verdict = nees < least ? "below" : nees > most ? "above" : "within";
    const ratio = nees / estimator.neesDegreesOfFreedom;
    return { ...look, errors, remark: "", consistency: Number.isFinite(ratio) ? { ratio, verdict } : null };
  });
}

export function boundReadings(run: Run, step: number): Reading[] {
  return shownBounds(run).map((bound) => {
    const errors = { angle: bound.orientation[step], position: bound.position[step] };
    return { ...boundRow(bound), errors, remark: bound.label, consistency: null };
  });
}

/** So many standard errors off 1 a mean NEES is not by chance. */
const SIGNIFICANT = 3;

/** The same rows for many trials: root mean square errors, and the bounds with the same definition. */
export function studyReadings(
  study: StudyCurves,
  step: number,
): { estimators: Reading[]; bounds: Reading[] } {
  const errorsOf = ({ angle, position }: { angle: Curve; position: Curve }) => ({
    angle: angle.value[step],
    position: position.value[step],
  });
  return {
    estimators: study.estimators.map((estimator) => {
      const { name, label, nees, failures } = estimator;
      const [ratio, room] = [nees.value[step], SIGNIFICANT * nees.standardError[step]];
      const verdict = ratio < 1 - room ? "below" : ratio > 1 + room ? "above" : "within";
      const remark = failures[step] > 0 ? `stopped in ${failures[step]} of ${study.trials} trials` : "";
      const consistency = Number.isFinite(ratio) ? ({ ratio, verdict } as const) : null;
      return { ...estimatorLook(name, label), errors: errorsOf(estimator), remark, consistency };
    }),
    bounds: shownOf(study.estimators, study.bounds).map((bound) => ({
      ...boundRow(bound),
      errors: errorsOf(bound),
      remark: bound.label,
      consistency: null,
    })),
  };
}

function estimatorLook(name: string, label: string) {
  return { name, label, token: name, mark: MARKS[name] ?? "disc", dash: [] };
}

function boundRow(bound: { name: string; label: string }) {
  const { short, dash } = boundLook(bound);
  return { name: bound.name, label: short, token: "bound", mark: null, dash };
}
