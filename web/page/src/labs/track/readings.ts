import { type Run, runsAt } from "../../run";
import type { Shape } from "../../scene/draw-list";
import { MARKS } from "../../theme/palette";
import { band } from "./findings/consistency";
import { boundLook, shownBounds } from "./plots";

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

/** NEES, its degrees of freedom, which are its mean where the covariance is right, and where it stands to the band of a consistent filter. */
export interface Consistency {
  readonly nees: number;
  readonly degreesOfFreedom: number;
  readonly verdict: "below" | "within" | "above";
}

export function estimatorReadings(run: Run, step: number): Reading[] {
  return run.estimators.map((estimator) => {
    const { name, label, stopped } = estimator;
    const look = { name, label, token: name, mark: MARKS[name] ?? "disc", dash: [] };
    if (!runsAt(estimator, step)) {
      const remark = `stopped at step ${(stopped?.step ?? 0) + 1}: ${stopped?.sentence}`;
      return { ...look, errors: null, remark, consistency: null };
    }
    const errors = { angle: estimator.orientationErrors[step], position: estimator.positionErrors[step] };
    const [least, most] = band(estimator);
    const nees = estimator.nees[step];
    const verdict = nees < least ? "below" : nees > most ? "above" : "within";
    const degreesOfFreedom = estimator.neesDegreesOfFreedom;
    const known = degreesOfFreedom > 0 && Number.isFinite(nees);
    return { ...look, errors, remark: "", consistency: known ? { nees, degreesOfFreedom, verdict } : null };
  });
}

export function boundReadings(run: Run, step: number): Reading[] {
  return shownBounds(run).map((bound) => {
    const { short, dash } = boundLook(bound);
    const errors = { angle: bound.orientation[step], position: bound.position[step] };
    const look = { name: bound.name, label: short, token: "bound", mark: null, dash };
    return { ...look, errors, remark: bound.label, consistency: null };
  });
}
