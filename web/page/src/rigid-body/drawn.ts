import type { Room } from "../family";
import type { LabRun } from "../lab";
import { matrixAt, pointAt, type PoseTrack } from "../run";
import type { Scenario } from "../scenario";
import { add, lift, scale, sub, transform, type Vec3 } from "../scene/geometry";
import { type Hull, hullOf } from "../scene/hull";
import type { SceneInput } from "../scene/input";

/** Where things of a run are drawn: bodies and errors are magnified around the true position. */

const hulls = new WeakMap<Room["body"], Hull>();

/** The hull of a topology is found once: documents share the list of sensors from edit to edit. */
export function hullOfSensors(sensors: Room["body"]): Hull {
  const known = hulls.get(sensors) ?? hullOf(sensors.map(lift));
  hulls.set(sensors, known);
  return known;
}

/** Where an estimate is drawn: its error from the truth is as much larger as the body is. */
export function drawnPosition(run: LabRun, track: PoseTrack, step: number, magnification: number): Vec3 {
  const truth = pointAt(run.truth.positions, step, run.dimension);
  if (track === run.truth) return truth;
  return add(truth, scale(sub(pointAt(track.positions, step, run.dimension), truth), magnification));
}

export function drawnSensors(input: SceneInput<LabRun>, run: LabRun, track: PoseTrack, step: number): Vec3[] {
  return drawnPlaces(input, run, track, step, input.room.body.map(lift));
}

/** Where places on the body (body frame) are drawn. */
export function drawnPlaces(
  { frame }: SceneInput<LabRun>,
  run: LabRun,
  track: PoseTrack,
  step: number,
  places: readonly Vec3[],
): Vec3[] {
  const rotation = matrixAt(track.orientations, step, run.dimension, 1);
  const centre = drawnPosition(run, track, step, frame.magnification);
  return places.map((place) => add(centre, scale(transform(rotation, place), frame.magnification)));
}

/** Metres that the axes of the body are drawn long. */
export function axisLength({ frame, room }: SceneInput<LabRun>): number {
  return 1.6 * frame.magnification * Math.max(...room.body.map((point) => Math.hypot(...point)));
}

/** Unit vectors along the axes of a body, two in the plane. */
export function axesOf(run: LabRun, track: PoseTrack, step: number): Vec3[] {
  const rotation = matrixAt(track.orientations, step, run.dimension, 1);
  const column = (i: number): Vec3 => [rotation[0][i], rotation[1][i], rotation[2][i]];
  return run.dimension === 2 ? [column(0), column(1)] : [column(0), column(1), column(2)];
}

const paths = new WeakMap<PoseTrack, { magnification: number; points: Float32Array }>();

/** All drawn positions of a track, three coordinates each; kept while only time and camera change. */
export function pathOf(run: LabRun, track: PoseTrack, magnification: number): Float32Array {
  const known = paths.get(track);
  if (known?.magnification === magnification) return known.points;
  const points = new Float32Array(3 * run.steps);
  for (let step = 0; step < run.steps; step++)
    points.set(drawnPosition(run, track, step, magnification), 3 * step);
  paths.set(track, { magnification, points });
  return points;
}

/** Distance of the farthest sensor from the body's origin, m. */
export function bodyRadius({ sensors }: Scenario): number {
  return Math.max(...sensors.map((sensor) => Math.hypot(...sensor)));
}
