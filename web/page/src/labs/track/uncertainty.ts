import { drawnPosition } from "../../rigid-body/drawn";
import { drawBoundFans, drawEllipsoid, fansOf } from "../../rigid-body/uncertainty";
import { type Run, runsAt } from "../../run";
import type { Scenario } from "../../scenario";
import type { Layer } from "../../scene/input";
import { shownBounds } from "./plots";

/** The 95 % ellipsoids of the position: what each estimator claims, and the bound as a full one. */
export const ellipsoids: Layer<Run, Scenario> = (input, out) => {
  const { run, step, palette, frame, uncertainty } = input;
  if (!run || !uncertainty.position) return;
  for (const estimator of run.estimators.filter((entry) => runsAt(entry, step))) {
    const centre = drawnPosition(run, estimator, step, frame.magnification);
    drawEllipsoid(input, centre, estimator.positionCovariances, palette.rgba(estimator.name, 0.1), out);
  }
  const [bound] = shownBounds(run);
  if (!bound) return;
  const centre = drawnPosition(run, run.truth, step, 1);
  drawEllipsoid(input, centre, bound.positionCovariances, palette.rgba("bound", 0.22), out);
};

/** The 95 % fans of the axes: the bound's around the true ones as a filled cone, each estimator's as a ring. */
export const fans: Layer<Run, Scenario> = (input, out) => {
  const { run, step, palette, uncertainty } = input;
  if (!run || !uncertainty.orientation) return;
  const [bound] = shownBounds(run);
  if (bound) drawBoundFans(input, run, bound.rotationCovariances, out);
  for (const estimator of run.estimators.filter((entry) => runsAt(entry, step))) {
    const color = palette.rgba(estimator.name);
    for (const { centre, tip, ring } of fansOf(input, run, estimator, estimator.rotationCovariances)) {
      out.line(centre, tip, { width: 1, color: palette.rgba(estimator.name, 0.6) });
      out.polyline(ring, { width: 1.5, color });
    }
  }
};
