import type { LabRun } from "../lab";
import { anchorPoints } from "../scene/anchors";
import type { DrawList } from "../scene/draw-list";
import { add, scale } from "../scene/geometry";
import type { Label, SceneInput } from "../scene/input";
import { axesOf, axisLength, drawnPosition, drawnSensors, hullOfSensors } from "./drawn";

/** More lines than this hide the scene: then each anchor gets one line to the body. */
const MOST_RANGE_LINES = 200;

/** A line for each range: full where there is one, dashed and fainter where it is missing. */
export function drawRanges(
  input: SceneInput,
  run: LabRun,
  there: (anchor: number, sensor: number) => boolean,
  out: DrawList,
): void {
  const { step, palette, room, frame } = input;
  const anchors = anchorPoints(input);
  const full = { width: 1, color: palette.rgba("range", 0.4) };
  const missing = { width: 1, color: palette.rgba("range", 0.25), dash: 4 };
  if (anchors.length * room.body.length > MOST_RANGE_LINES) {
    const body = drawnPosition(run, run.truth, step, frame.magnification);
    anchors.forEach((anchor, i) => {
      const any = room.body.some((_, j) => there(i, j));
      out.line(anchor, body, any ? { ...full, color: palette.rgba("range", 0.6) } : missing);
    });
    return;
  }
  const sensors = drawnSensors(input, run, run.truth, step);
  anchors.forEach((anchor, i) =>
    sensors.forEach((sensor, j) => out.line(anchor, sensor, there(i, j) ? full : missing)),
  );
}

/** The true body at the step shown: its hull, its sensors and its axes. */
export function drawBody(input: SceneInput, run: LabRun, out: DrawList): void {
  const { step, palette, room, frame } = input;
  const sensors = drawnSensors(input, run, run.truth, step);
  const { edges, faces } = hullOfSensors(room.body);
  for (const [i, j, k] of faces)
    out.triangle([sensors[i], sensors[j], sensors[k]], palette.rgba("truth", 0.1));
  for (const [i, j] of edges) out.line(sensors[i], sensors[j], { width: 2, color: palette.rgba("truth") });
  for (const sensor of sensors) out.point(sensor, 3, palette.rgba("truth"), "disc");
  const start = drawnPosition(run, run.truth, step, frame.magnification);
  const axes = axesOf(run, run.truth, step).map((axis) => scale(axis, axisLength(input)));
  axes.forEach((axis, i) =>
    out.arrow(start, axis, axes[(i + 1) % axes.length], { width: 2, color: palette.rgba("truth", 0.75) }),
  );
}

/** Letters just beyond the tips of the axes. */
export function axisLabels(input: SceneInput, run: LabRun): Label[] {
  const start = drawnPosition(run, run.truth, input.step, input.frame.magnification);
  const from = input.view.project(start);
  return axesOf(run, run.truth, input.step).map((axis, index) => {
    const at = add(start, scale(axis, axisLength(input)));
    const to = input.view.project(at);
    const share = 11 / Math.max(1, Math.hypot(to.x - from.x, to.y - from.y));
    return {
      id: `axis ${index}`,
      at,
      text: "xyz"[index],
      kind: "axis",
      offset: { x: (to.x - from.x) * share, y: (to.y - from.y) * share },
    };
  });
}
