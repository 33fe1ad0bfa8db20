import type { KinematicsBounds } from "../../engine";
import type { KinematicsName } from "../../generated/KinematicsName";
import type { KinematicsReport } from "../../generated/KinematicsReport";
import { boundOf, estimatorOf } from "./estimators";
import type { AnchorlessRun } from "./run";

/** What an estimator reached in one trial, or on the average over many, beside the bound for what it knows. */
export interface Level {
  readonly name: KinematicsName;
  readonly label: string;
  readonly senses: boolean;
  /** Root mean square errors of Y_0, Y_1, …, m/s^l. */
  readonly errors: readonly number[];
  /** Standard errors of these; null of one trial. */
  readonly standardErrors: readonly number[] | null;
  /** The bounds on them; empty where there are none. */
  readonly bounds: readonly number[];
  /** At the last instant with one alignment, and aligned then, m; null where it finds no motion. */
  readonly last: { readonly one: number; readonly aligned: number } | null;
}

/** Of one run; estimators that find no motion are left out. */
export function levelsOfRun({ trial, bounds }: AnchorlessRun): Level[] {
  return trial.estimators
    .filter(({ coefficient_errors }) => coefficient_errors.length > 0)
    .map(({ name, coefficient_errors, positionErrors, alignedPositionErrors }) => ({
      ...namesOf(name),
      errors: coefficient_errors,
      standardErrors: null,
      bounds: bounds[boundOf(name)].coefficients,
      last: { one: positionErrors.at(-1)!, aligned: alignedPositionErrors.at(-1)! },
    }));
}

/** On the average over trials. */
export function levelsOfReport(
  { estimators }: Pick<KinematicsReport, "estimators">,
  bounds: KinematicsBounds,
): Level[] {
  return estimators
    .filter(({ summary }) => summary.trials > 0 && summary.coefficients.length > 0)
    .map(({ name, summary: { coefficients, positions, aligned_positions } }) => ({
      ...namesOf(name),
      errors: coefficients.map(({ value }) => value),
      standardErrors: coefficients.map(({ standard_error }) => standard_error),
      bounds: bounds[boundOf(name)].coefficients,
      last: { one: positions.at(-1)!.value, aligned: aligned_positions.at(-1)!.value },
    }));
}

function namesOf(name: KinematicsName): Pick<Level, "name" | "label" | "senses"> {
  const { label, senses } = estimatorOf(name);
  return { name, label, senses };
}

/** How many times its bound an error is; null where there is no bound or no such coefficient. */
export function overBound({ errors, bounds }: Pick<Level, "errors" | "bounds">, l: number): number | null {
  const [error, bound] = [errors[l], bounds[l]];
  return error !== undefined && bound > 0 ? error / bound : null;
}
