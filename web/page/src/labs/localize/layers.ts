import type { Scenario } from "../../scenario";
import { axesOf, axisLength, drawnPosition, drawnSensors, hullOfSensors } from "../../rigid-body/drawn";
import { drawBody, drawRanges } from "../../rigid-body/layers";
import { matrixAt, pointAt, type PoseTrack } from "../../run";
import type { DrawList } from "../../scene/draw-list";
import { add, scale, transform } from "../../scene/geometry";
import type { Layer, SceneInput } from "../../scene/input";
import { type Cloud, poseIn } from "./cloud";
import { lookOf } from "./localizers";
import type { LocalizeRun } from "./run";

/** Dots of a cloud, and how faint they are where there are many. */
const DOT = 1.75;
const DOT_OPACITY = 0.6;

export const ranges: Layer<LocalizeRun, Scenario> = (input, out) => {
  if (input.run) drawRanges(input, input.run, () => true, out);
};

export const body: Layer<LocalizeRun, Scenario> = (input, out) => {
  if (input.run) drawBody(input, input.run, out);
};

/** For each trial a dot where the body is estimated to be, and one at the tip of each of its axes. */
export const clouds: Layer<LocalizeRun, Scenario> = (input, out) => {
  const { run, uncertainty } = input;
  for (const cloud of run?.clouds ?? []) {
    if (uncertainty.position) positions(input, cloud, out);
    if (uncertainty.orientation) tips(input, cloud, out);
  }
};

function positions(
  { run, frame, palette }: SceneInput<LocalizeRun, Scenario>,
  cloud: Cloud,
  out: DrawList,
): void {
  if (!run) return;
  const { token } = lookOf(cloud.name);
  const color = palette.rgba(token, DOT_OPACITY);
  const centre = drawnPosition(run, run.truth, 0, frame.magnification);
  for (let i = 0; i < cloud.count; i++) {
    const moved = pointAt(cloud.moved, i, run.dimension);
    out.point(add(centre, scale(moved, frame.magnification)), DOT, color, "disc");
  }
}

/** Around the true axes: what the position does not hide. A tip that a mirrored body has is a ring. */
function tips(input: SceneInput<LocalizeRun, Scenario>, cloud: Cloud, out: DrawList): void {
  const { run, frame, palette } = input;
  if (!run) return;
  const color = palette.rgba(lookOf(cloud.name).token, DOT_OPACITY);
  const centre = drawnPosition(run, run.truth, 0, frame.magnification);
  const axes = axesOf(run, run.truth, 0).map((axis) => scale(axis, axisLength(input)));
  for (let i = 0; i < cloud.count; i++) {
    const turned = matrixAt(cloud.turned, i, run.dimension, 1);
    const mirrored = cloud.mirrored[i];
    for (const axis of axes)
      out.point(
        add(centre, transform(turned, axis)),
        mirrored ? 2 * DOT : DOT,
        color,
        mirrored ? "ring" : "disc",
      );
  }
}

/** The estimates of the trial drawn, as bodies; dashed where they mirror it. */
export const estimates: Layer<LocalizeRun, Scenario> = (input, out) => {
  const { run, palette, frame } = input;
  if (!run) return;
  run.estimates.forEach(({ estimate, pose }, index) => {
    const { token, mark } = lookOf(estimate.name);
    // Estimates that agree lie on each other: earlier ones are drawn wider and show as rims.
    const rim = 0.3 * (run.estimates.length - 1 - index);
    outline(input, pose, token, 1.25 + rim, estimate.reflected ? 6 : 0, out);
    const centre = drawnPosition(run, pose, 0, frame.magnification);
    out.point(centre, 4 + rim, palette.rgba(token), mark);
  });
};

/** For each localizer that mirrors the body in other trials than the one drawn: the first such body, dashed. */
export const mirrored: Layer<LocalizeRun, Scenario> = (input, out) => {
  const { run } = input;
  if (!run) return;
  for (const cloud of unseenMirrors(run)) {
    const pose = poseIn(cloud, cloud.mirrored.indexOf(true), run.truth, run.dimension);
    outline(input, pose, lookOf(cloud.name).token, 1.5, 6, out);
  }
};

/** The clouds with a mirrored body that the trial drawn does not show. */
export function unseenMirrors({ clouds, estimates }: LocalizeRun): Cloud[] {
  return clouds.filter(
    ({ name, mirrored }) =>
      mirrored.includes(true) &&
      !estimates.some(({ estimate }) => estimate.name === name && estimate.reflected),
  );
}

function outline(
  input: SceneInput<LocalizeRun, Scenario>,
  pose: PoseTrack,
  token: string,
  width: number,
  dash: number,
  out: DrawList,
): void {
  const { run, scenario, palette } = input;
  if (!run) return;
  const sensors = drawnSensors(input, run, pose, 0);
  const style = { width, dash, color: palette.rgba(token) };
  for (const [i, j] of hullOfSensors(scenario.sensors).edges) out.line(sensors[i], sensors[j], style);
}
