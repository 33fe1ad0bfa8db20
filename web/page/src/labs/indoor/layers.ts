import type { FilterRun } from "../../engine";
import type { IndoorScenario } from "../../generated/IndoorScenario";
import { drawnPosition, drawnSensors, hullOfSensors, pathOf } from "../../rigid-body/drawn";
import { drawBody, drawRanges } from "../../rigid-body/layers";
import { drawEllipsoid, fansOf } from "../../rigid-body/uncertainty";
import { runsAt } from "../../run";
import type { Layer } from "../../scene/input";
import { filterOf } from "./filters";
import type { IndoorRun } from "./run";

type IndoorLayer = Layer<IndoorRun, IndoorScenario>;

const TRANSMITTERS = 3;

/** A line for each range that was taken at the step shown, dashed where it is missing; between fixes there are none. */
export const ranges: IndoorLayer = (input, out) => {
  const { run, step } = input;
  if (!run || run.fixes[step] !== 1) return;
  const M = run.anchors.length;
  // While beacons are added or removed the scene is one step ahead of the run.
  if (input.room.anchors.length !== M) return;
  const there = (m: number, n: number) => run.present[(step * M + m) * TRANSMITTERS + n] === 1;
  drawRanges(input, run, there, out);
};

export const truth: IndoorLayer = (input, out) => {
  const { run, step, palette, frame } = input;
  if (!run) return;
  const path = pathOf(run, run.truth, frame.magnification);
  out.path(path, step, run.steps - 1, { width: 1.5, color: palette.rgba("truth", 0.3) });
  out.path(path, 0, step, { width: 3, color: palette.rgba("truth") });
  drawBody(input, run, out);
};

/** What each filter claims: the 95 % ellipsoid of the position, and fans around its axes. */
export const uncertainty: IndoorLayer = (input, out) => {
  const { run, step, palette, frame } = input;
  if (!run) return;
  for (const filter of run.filters.filter((entry) => runsAt(entry, step))) {
    const { token } = filterOf(filter.name);
    if (input.uncertainty.position) {
      const centre = drawnPosition(run, filter, step, frame.magnification);
      drawEllipsoid(input, centre, filter.positionCovariances, palette.rgba(token, 0.14), out);
    }
    if (!input.uncertainty.orientation) continue;
    for (const { centre, tip, ring } of fansOf(input, run, filter, filter.rotationCovariances)) {
      out.line(centre, tip, { width: 1, color: palette.rgba(token, 0.6) });
      out.polyline(ring, { width: 1.5, color: palette.rgba(token) });
    }
  }
};

export const estimates: IndoorLayer = (input, out) => {
  const { run, step, palette, frame, room } = input;
  if (!run) return;
  const { edges } = hullOfSensors(room.body);
  run.filters.forEach((filter: FilterRun, index) => {
    const { token, mark, dash } = filterOf(filter.name);
    // Estimates that agree lie on each other: earlier ones are drawn wider and show as rims.
    const rim = 0.5 * (run.filters.length - 1 - index);
    const last = (filter.stopped?.step ?? run.steps) - 1;
    const path = pathOf(run, filter, frame.magnification);
    const style = { width: 1.5 + rim, color: palette.rgba(token), dash: dash[0] ?? 0 };
    out.path(path, step, last, { ...style, width: 1.25, color: palette.rgba(token, 0.3) });
    out.path(path, 0, Math.min(step, last), style);
    if (!runsAt(filter, step)) return;
    const corners = drawnSensors(input, run, filter, step);
    for (const [i, j] of edges) out.line(corners[i], corners[j], { ...style, dash: 0 });
    const centre = drawnPosition(run, filter, step, frame.magnification);
    out.point(centre, 4.5 + 2 * rim, palette.rgba(token), mark);
  });
};
