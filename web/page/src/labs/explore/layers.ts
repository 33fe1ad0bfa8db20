import type { Scenario } from "../../scenario";
import type { ExploreRun } from "./run";
import { bodyRadius, drawnPlaces, drawnPosition, drawnSensors, hullOfSensors } from "../../rigid-body/drawn";
import { drawBody, drawRanges } from "../../rigid-body/layers";
import { cloudOf } from "../../rigid-body/mounting";
import { drawBoundFans, drawEllipsoid } from "../../rigid-body/uncertainty";
import { matrixAt } from "../../run";
import { add, lift, scale, sub, transform, type Vec3 } from "../../scene/geometry";
import { fieldContourLabels, fieldContours } from "../../scene/contours";
import type { Label, Layer, SceneInput } from "../../scene/input";
import { fields, picture, unitOf } from "./fields";
import { type Motion, motionOf, turned } from "./motion";
import { boundsAt, pointUnder } from "./probe.svelte";

/** A line for each range: dashed where the anchor is too far away or does not see the sensor. */
export const ranges: Layer<ExploreRun, Scenario> = (input, out) => {
  const { run } = input;
  if (run)
    drawRanges(input, run, (anchor, sensor) => run.exploration.available[anchor]?.[sensor] ?? true, out);
};

export const body: Layer<ExploreRun, Scenario> = (input, out) => {
  if (input.run) drawBody(input, input.run, out);
};

/** Where the sensors may sit on the body: a dot for each and each of some trials. */
export const mounting: Layer<ExploreRun, Scenario> = (input, out) => {
  const { run, scenario, palette } = input;
  if (!run) return;
  const color = palette.rgba("truth", 0.5);
  for (const place of drawnPlaces(input, run, run.truth, 0, cloudOf(scenario)))
    out.point(place, 1.5, color, "disc");
};

/** The bounds of the pose: an ellipsoid of the position, fans of the axes. */
export const bounds: Layer<ExploreRun, Scenario> = (input, out) => {
  const { run, palette, uncertainty, frame } = input;
  if (!run) return;
  const { position_covariance: position, rotation_covariance_in_world: rotation } = run.exploration;
  const centre = drawnPosition(run, run.truth, 0, frame.magnification);
  if (position && uncertainty.position)
    drawEllipsoid(input, centre, Float64Array.from(position.flat()), palette.rgba("bound", 0.22), out);
  if (rotation && uncertainty.orientation) drawBoundFans(input, run, Float64Array.from(rotation.flat()), out);
};

/** Lines of equal bound, with round numbers in the unit that is shown. */
export const contours: Layer<ExploreRun, Scenario> = (input, out) => {
  const field = picture(input);
  if (field) fieldContours(input, out, field, unitOf(input.scenario).factor);
};

export function contourLabels(input: SceneInput<ExploreRun, Scenario>): Label[] {
  const field = picture(input);
  const { unit, factor } = unitOf(input.scenario);
  return field ? fieldContourLabels(field, factor, unit) : [];
}

/** How the motion that is seen least is drawn; null where there is none. */
export function weakestMotion({ run, scenario, frame }: SceneInput<ExploreRun, Scenario>): Motion | null {
  const mode = run?.exploration.modes[0];
  if (!mode) return null;
  return motionOf(mode, bodyRadius(scenario), (0.5 * frame.radius) / frame.magnification);
}

/** The body moved along the motion that is seen least, to both sides. */
export const ghosts: Layer<ExploreRun, Scenario> = (input, out) => {
  const { run, scenario, palette, frame } = input;
  const motion = weakestMotion(input);
  if (!run || !motion) return;
  const rotation = matrixAt(run.truth.orientations, 0, run.dimension, 1);
  const centre = drawnPosition(run, run.truth, 0, frame.magnification);
  for (const sign of [1, -1]) {
    const origin = add(centre, scale(motion.shift, sign * frame.magnification));
    const sensors = scenario.sensors.map((sensor) => {
      const moved = transform(rotation, turned(lift(sensor), scale(motion.rotation, sign)));
      return add(origin, scale(moved, frame.magnification));
    });
    const color = palette.rgba("accent", sign > 0 ? 0.9 : 0.4);
    outline(input, sensors, { width: 1.5, color }, out);
    if (sign > 0) paths(input, run, sensors, out);
  }
};

/** From each sensor to where the motion takes it. */
function paths(
  input: SceneInput<ExploreRun, Scenario>,
  run: ExploreRun,
  moved: readonly Vec3[],
  out: Out,
): void {
  const color = input.palette.rgba("accent", 0.5);
  drawnSensors(input, run, run.truth, 0).forEach((sensor, index) =>
    out.line(sensor, moved[index], { width: 1, color }),
  );
}

/** The other body that all ranges fit: around its own middle as much larger as the true one. */
export const twin: Layer<ExploreRun, Scenario> = (input, out) => {
  const { run, palette, frame } = input;
  const sensors = run?.exploration.twin?.sensors.map(lift);
  if (!sensors) return;
  const middle = scale(sensors.reduce(add), 1 / sensors.length);
  const drawn = sensors.map((sensor) => add(middle, scale(sub(sensor, middle), frame.magnification)));
  outline(input, drawn, { width: 2, dash: 5, color: palette.rgba("warning") }, out);
  for (const sensor of drawn) out.point(sensor, 3, palette.rgba("warning"), "ring");
};

/** Where the field is read by the pointer, and the ellipsoid of the position there. */
export const reading: Layer<ExploreRun, Scenario> = (input, out) => {
  const { scenario, palette, uncertainty } = input;
  const point = pointUnder(input.ray, fields.field, scenario.dimension);
  if (!point) return;
  out.point(lift(point), 6, palette.rgba("accent"), "cross");
  if (scenario.field.subject !== "body") return;
  const covariance = boundsAt(scenario, point)?.position_covariance;
  if (covariance && uncertainty.position)
    drawEllipsoid(
      input,
      lift(point),
      Float64Array.from(covariance.flat()),
      palette.rgba("accent", 0.25),
      out,
    );
};

type Out = Parameters<Layer>[1];

function outline(
  { scenario }: SceneInput<ExploreRun, Scenario>,
  sensors: readonly Vec3[],
  style: Parameters<Out["line"]>[2],
  out: Out,
): void {
  for (const [i, j] of hullOfSensors(scenario.sensors).edges) out.line(sensors[i], sensors[j], style);
}
