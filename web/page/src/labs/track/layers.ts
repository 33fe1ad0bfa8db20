import type { Scenario } from "../../scenario";
import { type Run, runsAt } from "../../run";
import type { Layer } from "../../scene/input";
import { MARKS } from "../../theme/palette";
import { drawnPosition, drawnSensors, hullOfSensors, pathOf } from "../../rigid-body/drawn";
import { drawBody, drawRanges } from "../../rigid-body/layers";

/** A line for each range: full where it was measured, dashed and fainter where it is missing at this step. */
export const ranges: Layer<Run, Scenario> = (input, out) => {
  const { run, step, scenario } = input;
  if (!run) return;
  const [M, N] = [run.anchors.length, scenario.sensors.length];
  if (run.present.length !== run.steps * M * N) return;
  drawRanges(input, run, (anchor, sensor) => run.present[(step * M + anchor) * N + sensor] === 1, out);
};

export const truth: Layer<Run, Scenario> = (input, out) => {
  const { run, step, palette, frame } = input;
  if (!run) return;
  const path = pathOf(run, run.truth, frame.magnification);
  out.path(path, step, run.steps - 1, { width: 1.5, color: palette.rgba("truth", 0.3) });
  out.path(path, 0, step, { width: 3, color: palette.rgba("truth") });
  drawBody(input, run, out);
};

export const estimates: Layer<Run, Scenario> = (input, out) => {
  const { run, step, palette, frame, scenario } = input;
  if (!run) return;
  const { edges } = hullOfSensors(scenario.sensors);
  run.estimators.forEach((estimator, index) => {
    // Estimates that agree lie on each other: earlier ones are drawn wider and show as rims.
    const rim = 0.5 * (run.estimators.length - 1 - index);
    const last = (estimator.stopped?.step ?? run.steps) - 1;
    const path = pathOf(run, estimator, frame.magnification);
    const color = palette.rgba(estimator.name);
    out.path(path, step, last, { width: 1.25, color: palette.rgba(estimator.name, 0.3) });
    out.path(path, 0, Math.min(step, last), { width: 1.5 + rim, color });
    if (!runsAt(estimator, step)) return;
    const sensors = drawnSensors(input, run, estimator, step);
    for (const [i, j] of edges) out.line(sensors[i], sensors[j], { width: 1.5 + rim, color });
    const centre = drawnPosition(run, estimator, step, frame.magnification);
    out.point(centre, 4.5 + 2 * rim, color, MARKS[estimator.name] ?? "disc");
  });
};
