import type { Scenario } from "../../scenario";
import { DEGREES_PER_RADIAN, formatNumber, formatPoint, formatReading } from "../../controls/format";
import { type EstimatorRun, matrixAt, pointAt, type Run, runsAt } from "../../run";
import { axisAngle } from "../../scene/axis-angle";
import { toldMounting } from "../../rigid-body/mounting";
import type { SceneInput } from "../../scene/input";

/** Ranges that were not measured at the step shown. */
export function missingRanges({ run, step }: SceneInput<Run, Scenario>): { missing: number; all: number } {
  if (!run) return { missing: 0, all: 0 };
  const all = run.present.length / run.steps;
  const here = run.present.subarray(step * all, (step + 1) * all);
  return { missing: here.reduce((count, present) => count + 1 - present, 0), all };
}

export function note(input: SceneInput<Run, Scenario>): string {
  const { missing, all } = missingRanges(input);
  return missing === 0 ? "" : `${missing} of ${all} ranges missing at this step: dashed`;
}

/** The body and its estimates at the step shown, in words. */
export function told(input: SceneInput<Run, Scenario>): string[] {
  const { run, scenario, step } = input;
  if (!run) return [];
  const { missing, all } = missingRanges(input);
  return [
    `Body turned by ${turn(matrixAt(run.truth.orientations, step, run.dimension, 1), run.dimension)}.`,
    missing === 0 ? `All ${all} ranges are measured.` : `${missing} of ${all} ranges are missing.`,
    ...toldMounting(scenario),
    ...run.estimators.map((estimator) => toldOf(estimator, run, step)),
  ];
}

function toldOf(estimator: EstimatorRun, run: Run, step: number): string {
  if (!runsAt(estimator, step)) return `${estimator.label} has stopped.`;
  const position = pointAt(estimator.positions, step, run.dimension).slice(0, run.dimension);
  const place = formatPoint(position.map((value) => Number(value.toPrecision(4))));
  const degrees = formatReading(estimator.orientationErrors[step] * DEGREES_PER_RADIAN);
  const metres = formatReading(estimator.positionErrors[step]);
  return `${estimator.label} at ${place}, ${metres} m and ${degrees} degrees from the body.`;
}

function turn(rotation: number[][], dimension: number): string {
  const { axis, angle } = axisAngle(rotation);
  if (dimension === 2) return `${formatReading(angle * Math.sign(axis[2]) * DEGREES_PER_RADIAN)} degrees`;
  const about = axis.map((value) => formatNumber(Number(value.toFixed(2)))).join(", ");
  return `${formatReading(angle * DEGREES_PER_RADIAN)} degrees about (${about})`;
}
