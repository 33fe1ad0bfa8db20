import type { Layer, SceneInput } from "../../scene/input";
import { type EstimatorRun, matrixAt, pointAt, type PoseTrack, type Run, runsAt } from "../../run";
import type { Scenario } from "../../scenario";
import { anchorPoints } from "../../scene/anchors";
import type { Color } from "../../scene/draw-list";
import { ellipsoidAxes } from "../../scene/ellipsoid";
import { add, lift, scale, sub, transform, type Vec3 } from "../../scene/geometry";
import { type Hull, hullOf } from "../../scene/hull";
import { MARKS } from "../../theme/palette";
import { shownBounds } from "./plots";

/** More lines than this hide the scene: then each anchor gets one line to the body. */
const MOST_RANGE_LINES = 200;

const hulls = new WeakMap<Scenario["sensors"], Hull>();

/** The hull of a topology is found once: scenarios share the list of sensors from edit to edit. */
function hullOfSensors(sensors: Scenario["sensors"]): Hull {
  const known = hulls.get(sensors) ?? hullOf(sensors.map(lift));
  hulls.set(sensors, known);
  return known;
}

/** Where an estimate is drawn: its error from the truth is as much larger as the body is. */
export function drawnPosition(run: Run, track: PoseTrack, step: number, magnification: number): Vec3 {
  const truth = pointAt(run.truth.positions, step, run.dimension);
  if (track === run.truth) return truth;
  return add(truth, scale(sub(pointAt(track.positions, step, run.dimension), truth), magnification));
}

function sensorPoints(
  { scenario, frame }: SceneInput<Run>,
  run: Run,
  track: PoseTrack,
  step: number,
): Vec3[] {
  const rotation = matrixAt(track.orientations, step, run.dimension, 1);
  const centre = drawnPosition(run, track, step, frame.magnification);
  return scenario.sensors.map((sensor) =>
    add(centre, scale(transform(rotation, lift(sensor)), frame.magnification)),
  );
}

export const ranges: Layer<Run> = (input, out) => {
  const { run, step, palette, scenario, frame } = input;
  if (!run) return;
  const anchors = anchorPoints(input);
  const many = anchors.length * scenario.sensors.length > MOST_RANGE_LINES;
  const ends = many
    ? [drawnPosition(run, run.truth, step, frame.magnification)]
    : sensorPoints(input, run, run.truth, step);
  const style = { width: 1, color: palette.rgba("range", many ? 0.6 : 0.38) };
  for (const anchor of anchors) for (const end of ends) out.line(anchor, end, style);
};

export const truth: Layer<Run> = (input, out) => {
  const { run, step, palette, scenario, frame } = input;
  if (!run) return;
  const path = pathOf(run, run.truth, frame.magnification, run.steps);
  out.polyline(path, { width: 1.5, color: palette.rgba("truth", 0.3) });
  out.polyline(path.slice(0, step + 1), { width: 3, color: palette.rgba("truth") });
  const sensors = sensorPoints(input, run, run.truth, step);
  const { edges, faces } = hullOfSensors(scenario.sensors);
  for (const [i, j, k] of faces)
    out.triangle([sensors[i], sensors[j], sensors[k]], palette.rgba("truth", 0.1));
  for (const [i, j] of edges) out.line(sensors[i], sensors[j], { width: 2, color: palette.rgba("truth") });
  for (const sensor of sensors) out.point(sensor, 3, palette.rgba("truth"), "disc");
  for (const { start, vector, side } of bodyAxes(input, run))
    out.arrow(start, vector, side, { width: 2, color: palette.rgba("truth", 0.75) });
};

/** The axes of the body at the current step, as arrows from its origin. */
export function bodyAxes(input: SceneInput<Run>, run: Run): { start: Vec3; vector: Vec3; side: Vec3 }[] {
  const { frame, scenario, step } = input;
  const rotation = matrixAt(run.truth.orientations, step, run.dimension, 1);
  const start = drawnPosition(run, run.truth, step, frame.magnification);
  const reach = Math.max(...scenario.sensors.map((sensor) => Math.hypot(...sensor)));
  const column = (index: number): Vec3 =>
    scale([rotation[0][index], rotation[1][index], rotation[2][index]], 1.6 * reach * frame.magnification);
  const axes = run.dimension === 2 ? [0, 1] : [0, 1, 2];
  return axes.map((axis) => ({ start, vector: column(axis), side: column((axis + 1) % axes.length) }));
}

export const estimates: Layer<Run> = (input, out) => {
  const { run, step, palette, frame, scenario } = input;
  if (!run) return;
  const { edges } = hullOfSensors(scenario.sensors);
  run.estimators.forEach((estimator, index) => {
    // Estimates that agree lie on each other: earlier ones are drawn wider and show as rims.
    const rim = 0.5 * (run.estimators.length - 1 - index);
    const end = estimator.stopped ? estimator.stopped.step : run.steps;
    const path = pathOf(run, estimator, frame.magnification, end);
    const color = palette.rgba(estimator.name);
    out.polyline(path, { width: 1.25, color: palette.rgba(estimator.name, 0.3) });
    out.polyline(path.slice(0, step + 1), { width: 1.5 + rim, color });
    if (!runsAt(estimator, step)) return;
    const sensors = sensorPoints(input, run, estimator, step);
    for (const [i, j] of edges) out.line(sensors[i], sensors[j], { width: 1.5 + rim, color });
    out.point(path[step], 4.5 + 2 * rim, color, MARKS[estimator.name] ?? "disc");
  });
};

/** The 95 % ellipsoids of the position: what each estimator claims, and the bound as a full one. */
export const uncertainty: Layer<Run> = ({ run, step, palette, frame, uncertainty: shown }, out) => {
  if (!run || !shown.position) return;
  const draw = (centre: Vec3, covariances: Float64Array, color: Color) => {
    const axes = ellipsoidAxes(covariances, step, run.dimension, frame.magnification);
    if (axes && axes.every((axis) => Math.hypot(...axis) < 3 * frame.radius))
      out.ellipsoid(centre, axes, color);
  };
  for (const estimator of run.estimators.filter((entry) => runsAt(entry, step))) {
    const centre = drawnPosition(run, estimator, step, frame.magnification);
    draw(centre, estimator.positionCovariances, palette.rgba(estimator.name, 0.1));
  }
  const [bound] = shownBounds(run);
  if (bound)
    draw(drawnPosition(run, run.truth, step, 1), bound.positionCovariances, palette.rgba("bound", 0.22));
};

function pathOf(run: Run, track: EstimatorRun | PoseTrack, magnification: number, end: number): Vec3[] {
  return Array.from({ length: end }, (_, step) => drawnPosition(run, track, step, magnification));
}
