import { type Run, runsAt } from "../../run";
import { anchorPoints } from "../../scene/anchors";
import { scale } from "../../scene/geometry";
import type { Layer } from "../../scene/input";
import { MARKS } from "../../theme/palette";
import { axesOf, axisLength, drawnPosition, drawnSensors, hullOfSensors, pathOf } from "./drawn";

/** More lines than this hide the scene: then each anchor gets one line to the body. */
const MOST_RANGE_LINES = 200;

/** A line for each range: full where it was measured, dashed and fainter where it is missing at this step. */
export const ranges: Layer<Run> = (input, out) => {
  const { run, step, palette, scenario, frame } = input;
  if (!run) return;
  const anchors = anchorPoints(input);
  const [M, N] = [anchors.length, scenario.sensors.length];
  if (run.present.length !== run.steps * M * N) return;
  const measured = (anchor: number, sensor: number) => run.present[(step * M + anchor) * N + sensor] === 1;
  const full = { width: 1, color: palette.rgba("range", 0.4) };
  const missing = { width: 1, color: palette.rgba("range", 0.25), dash: 4 };
  if (M * N > MOST_RANGE_LINES) {
    const body = drawnPosition(run, run.truth, step, frame.magnification);
    anchors.forEach((anchor, i) => {
      const any = scenario.sensors.some((_, j) => measured(i, j));
      out.line(anchor, body, any ? { ...full, color: palette.rgba("range", 0.6) } : missing);
    });
    return;
  }
  const sensors = drawnSensors(input, run, run.truth, step);
  anchors.forEach((anchor, i) =>
    sensors.forEach((sensor, j) => out.line(anchor, sensor, measured(i, j) ? full : missing)),
  );
};

export const truth: Layer<Run> = (input, out) => {
  const { run, step, palette, scenario, frame } = input;
  if (!run) return;
  const path = pathOf(run, run.truth, frame.magnification);
  out.path(path, step, run.steps - 1, { width: 1.5, color: palette.rgba("truth", 0.3) });
  out.path(path, 0, step, { width: 3, color: palette.rgba("truth") });
  const sensors = drawnSensors(input, run, run.truth, step);
  const { edges, faces } = hullOfSensors(scenario.sensors);
  for (const [i, j, k] of faces)
    out.triangle([sensors[i], sensors[j], sensors[k]], palette.rgba("truth", 0.1));
  for (const [i, j] of edges) out.line(sensors[i], sensors[j], { width: 2, color: palette.rgba("truth") });
  for (const sensor of sensors) out.point(sensor, 3, palette.rgba("truth"), "disc");
  const start = drawnPosition(run, run.truth, step, frame.magnification);
  const axes = axesOf(run, run.truth, step).map((axis) => scale(axis, axisLength(input)));
  axes.forEach((axis, i) =>
    out.arrow(start, axis, axes[(i + 1) % axes.length], { width: 2, color: palette.rgba("truth", 0.75) }),
  );
};

export const estimates: Layer<Run> = (input, out) => {
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
