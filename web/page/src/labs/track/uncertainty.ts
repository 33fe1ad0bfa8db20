import { matrixAt, type PoseTrack, type Run, runsAt } from "../../run";
import { fanAround } from "../../scene/axis-fan";
import type { Color, DrawList } from "../../scene/draw-list";
import { ellipsoidAxes } from "../../scene/ellipsoid";
import { add, length, normalize, scale, sub, type Vec3 } from "../../scene/geometry";
import type { Layer, SceneInput } from "../../scene/input";
import { axesOf, axisLength, drawnPosition } from "../../rigid-body/drawn";
import { shownBounds } from "./plots";

/** The 95 % ellipsoids of the position: what each estimator claims, and the bound as a full one. */
export const ellipsoids: Layer<Run> = ({ run, step, palette, frame, uncertainty }, out) => {
  if (!run || !uncertainty.position) return;
  const draw = (centre: Vec3, covariances: Float64Array, color: Color) => {
    const axes = ellipsoidAxes(covariances, step, run.dimension, frame.magnification);
    if (axes && axes.every((axis) => length(axis) < 3 * frame.radius)) out.ellipsoid(centre, axes, color);
  };
  for (const estimator of run.estimators.filter((entry) => runsAt(entry, step))) {
    const centre = drawnPosition(run, estimator, step, frame.magnification);
    draw(centre, estimator.positionCovariances, palette.rgba(estimator.name, 0.1));
  }
  const [bound] = shownBounds(run);
  if (bound)
    draw(drawnPosition(run, run.truth, step, 1), bound.positionCovariances, palette.rgba("bound", 0.22));
};

/** Fans narrower than this many CSS pixels would only blot the tips of the axes. */
const NARROWEST = 6;

/** The 95 % fans of the axes: the bound's around the true ones as a filled cone, each estimator's as a ring. */
export const fans: Layer<Run> = (input, out) => {
  const { run, step, palette, uncertainty } = input;
  if (!run || !uncertainty.orientation) return;
  const [bound] = shownBounds(run);
  if (bound) {
    const look = { width: 1.75, color: palette.rgba("bound"), dash: 4 };
    for (const { centre, ring } of fansOf(input, run, run.truth, bound.rotationCovariances)) {
      fill(out, centre, ring, palette.rgba("bound", 0.16));
      out.polyline(ring, look);
    }
  }
  for (const estimator of run.estimators.filter((entry) => runsAt(entry, step))) {
    const color = palette.rgba(estimator.name);
    for (const { centre, tip, ring } of fansOf(input, run, estimator, estimator.rotationCovariances)) {
      out.line(centre, tip, { width: 1, color: palette.rgba(estimator.name, 0.6) });
      out.polyline(ring, { width: 1.5, color });
    }
  }
};

interface Fan {
  readonly centre: Vec3;
  readonly tip: Vec3;
  readonly ring: readonly Vec3[];
}

/** One fan an axis, as long as the axes are drawn, where they are wide enough to be seen. */
function fansOf(input: SceneInput<Run>, run: Run, track: PoseTrack, covariances: Float64Array): Fan[] {
  const { step, frame, view } = input;
  const covariance = rotationCovariance(covariances, step, run.dimension);
  const centre = drawnPosition(run, track, step, frame.magnification);
  const reach = axisLength(input);
  const shortest = NARROWEST * view.metresPerPixel(centre);
  return axesOf(run, track, step)
    .map(normalize)
    .flatMap((axis) => {
      const ring = fanAround(axis, covariance, run.dimension === 2);
      const tip = add(centre, scale(axis, reach));
      const points = ring?.map((direction) => add(centre, scale(direction, reach))) ?? [];
      const widest = Math.max(0, ...points.map((point) => length(sub(point, tip))));
      return widest < shortest ? [] : [{ centre, tip, ring: points }];
    });
}

/** Three by three; in the plane only the turn about z is uncertain. */
function rotationCovariance(covariances: Float64Array, step: number, dimension: number): number[][] {
  if (dimension === 3) return matrixAt(covariances, step, 3, 0);
  return [
    [0, 0, 0],
    [0, 0, 0],
    [0, 0, covariances[step]],
  ];
}

function fill(out: DrawList, centre: Vec3, ring: readonly Vec3[], color: Color): void {
  for (let i = 1; i < ring.length; i++) out.triangle([centre, ring[i - 1], ring[i]], color);
}
