import { DEGREES_PER_RADIAN, formatReading } from "../../controls/format";
import { type Run, runsAt } from "../../run";
import { boundLook, eventSteps, shownBounds } from "./plots";

/** What the run shows at its last step, in one or two sentences. */
export function describe(run: Run): string {
  const last = run.steps - 1;
  const running = run.estimators.filter((estimator) => runsAt(estimator, last));
  if (running.length === 0) return "No estimator ran to the last step.";
  const best = running.reduce((a, b) => (b.orientationErrors[last] < a.orientationErrors[last] ? b : a));
  const degrees = formatReading(best.orientationErrors[last] * DEGREES_PER_RADIAN);
  const metres = formatReading(best.positionErrors[last]);
  const first = `${best.label} ends nearest in orientation, ${degrees}° and ${metres} m off${boundClause(run, last)}.`;
  return [first, eventSentence(run)].join(" ").trim();
}

function boundClause(run: Run, step: number): string {
  const [bound] = shownBounds(run);
  if (!bound) return "";
  const degrees = formatReading(bound.orientation[step] * DEGREES_PER_RADIAN);
  return ` (${boundLook(bound).short} ${degrees}° and ${formatReading(bound.position[step])} m)`;
}

function eventSentence(run: Run): string {
  const triggered = run.estimators.find((estimator) => estimator.name === "et-kf");
  if (!triggered) return "";
  const count = eventSteps(triggered).length;
  return `ET-KF projected at ${count} of ${run.steps} steps.`;
}
