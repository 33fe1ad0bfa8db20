import type { Finding } from "../../../findings";
import { type Run, runsAt } from "../../../run";
import { cautious, overconfident, surprised } from "./consistency";
import { mirrored, nearest, projected, stopped } from "./errors";
import { weakGeometry } from "./geometry";

/** Everything that is worth saying, in the order in which it is read. */
export function findings(run: Run, step: number): Finding[] {
  const running = run.estimators.filter((estimator) => runsAt(estimator, step));
  return [
    stopped(run, step),
    mirrored(run, running, step),
    nearest(run, running, step),
    overconfident(running, step),
    projected(run, step),
    weakGeometry(run, step),
    surprised(running, step),
    cautious(running, step),
  ].filter((finding) => finding !== null);
}
