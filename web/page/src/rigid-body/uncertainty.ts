import type { LabRun } from "../lab";
import { matrixAt, type PoseTrack } from "../run";
import { fanAround } from "../scene/axis-fan";
import type { Color, DrawList } from "../scene/draw-list";
import { ellipsoidAxes } from "../scene/ellipsoid";
import { add, length, normalize, scale, sub, type Vec3 } from "../scene/geometry";
import type { SceneInput } from "../scene/input";
import { axesOf, axisLength, drawnPosition } from "./drawn";

/** The 95 % ellipsoid of a position covariance (K x D x D numbers, square metres), unless it would swallow the scene. */
export function drawEllipsoid(
  { step, room, frame }: SceneInput,
  centre: Vec3,
  covariances: Float64Array,
  color: Color,
  out: DrawList,
): void {
  const axes = ellipsoidAxes(covariances, step, room.dimension, frame.magnification);
  if (axes && axes.every((axis) => length(axis) < 3 * frame.radius)) out.ellipsoid(centre, axes, color);
}

/** The 95 % fans of a bound around the true axes, as filled cones. */
export function drawBoundFans(
  input: SceneInput,
  run: LabRun,
  covariances: Float64Array,
  out: DrawList,
): void {
  const { palette } = input;
  const look = { width: 1.75, color: palette.rgba("bound"), dash: 4 };
  for (const { centre, ring } of fansOf(input, run, run.truth, covariances)) {
    fill(out, centre, ring, palette.rgba("bound", 0.16));
    out.polyline(ring, look);
  }
}

/** Fans narrower than this many CSS pixels would only blot the tips of the axes. */
const NARROWEST = 6;

export interface Fan {
  readonly centre: Vec3;
  readonly tip: Vec3;
  readonly ring: readonly Vec3[];
}

/** One fan an axis, as long as the axes are drawn, where they are wide enough to be seen. */
export function fansOf(input: SceneInput, run: LabRun, track: PoseTrack, covariances: Float64Array): Fan[] {
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
