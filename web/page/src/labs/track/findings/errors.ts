import { DEGREES_PER_RADIAN, formatReading } from "../../../controls/format";
import { type BoundRun, type EstimatorRun, matrixAt, type Run, runsAt } from "../../../run";
import { eventSteps } from "../plots";
import { asSentence, countOf, joined } from "../../../words";
import type { Finding } from "../../../findings";

/** Estimators that gave up, with the reason of the first. */
export function stopped(run: Run, step: number): Finding | null {
  const gone = run.estimators.filter((estimator) => !runsAt(estimator, step));
  const [first] = gone.toSorted((one, other) => (one.stopped?.step ?? 0) - (other.stopped?.step ?? 0));
  if (!first?.stopped) return null;
  const others = gone.length > 1 ? `, and ${countOf(gone.length - 1)} more` : "";
  return {
    weight: 100,
    text: `${first.label} stopped at step ${first.stopped.step + 1}${others}: ${asSentence(first.stopped.sentence)}`,
  };
}

/** Estimates that no turn of the body could have made. */
export function mirrored(run: Run, running: EstimatorRun[], step: number): Finding | null {
  const found = running.filter(
    ({ orientations }) => determinant(matrixAt(orientations, step, run.dimension, 1)) < 0,
  );
  if (found.length === 0) return null;
  const bodies = found.length === 1 ? "reports a mirrored body" : "report mirrored bodies";
  return { weight: 90, text: `${joined(found)} ${bodies}: det Q < 0.` };
}

/** The estimator that was nearest so far, and how near it and its bound are now. */
export function nearest(run: Run, running: EstimatorRun[], step: number): Finding | null {
  if (run.estimators.length === 0) return { weight: 50, text: "No estimator is switched on." };
  if (running.length === 0) return null;
  const best = running.reduce((one, other) =>
    meanSquare(other.orientationErrors, step) < meanSquare(one.orientationErrors, step) ? other : one,
  );
  const bound = boundOf(run, best);
  const error = errorText(best.orientationErrors[step], best.positionErrors[step]);
  const least = bound ? `; the bound is ${errorText(bound.orientation[step], bound.position[step])}` : "";
  return { weight: 50, text: `Nearest so far: ${best.label}, ${error} off${least}.` };
}

/** How often the trigger of the ET-KF acted up to the step. */
export function projected(run: Run, step: number): Finding | null {
  const triggered = run.estimators.find((estimator) => estimator.name === "et-kf");
  if (!triggered) return null;
  const count = eventSteps(triggered).filter((at) => at <= step).length;
  const far = step === run.steps - 1 ? `${run.steps} steps` : `${step + 1} steps so far`;
  return { weight: count > 0 ? 45 : 20, text: `ET-KF projected at ${count} of ${far}.` };
}

/** The bound for what the estimator knows: with or without `||s||^2` projected out. */
function boundOf(run: Run, estimator: EstimatorRun): BoundRun | undefined {
  const name = estimator.name === "eskf-raw" ? "posterior_crb_raw" : "posterior_crb";
  return run.bounds.find((bound) => bound.name === name);
}

function errorText(angle: number, position: number): string {
  return `${formatReading(angle * DEGREES_PER_RADIAN)}° and ${formatReading(position)} m`;
}

function meanSquare(values: Float64Array, last: number): number {
  return values.subarray(0, last + 1).reduce((sum, value) => sum + value * value, 0) / (last + 1);
}

function determinant([a, b, c]: number[][]): number {
  return (
    a[0] * (b[1] * c[2] - b[2] * c[1]) +
    a[1] * (b[2] * c[0] - b[0] * c[2]) +
    a[2] * (b[0] * c[1] - b[1] * c[0])
  );
}
