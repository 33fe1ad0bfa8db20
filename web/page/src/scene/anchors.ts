import type { Room } from "../family";
import type { LabRun } from "../lab";
import { START } from "../state/handles";
import type { Thing } from "../state/things";
import type { DrawList } from "./draw-list";
import { lift, type Vec3 } from "./geometry";
import type { Label, Layer, SceneInput } from "./input";
import { heightHandle } from "./picking";

const ANCHOR_RADIUS = 6.5;
const START_RADIUS = 4;

/** The anchors that were used: the run's where there is one, for presets that draw them anew. */
export function anchorPoints({ room, run }: { room: Room; run: LabRun | null }): Vec3[] {
  return (!room.movable && run !== null ? run.anchors : room.anchors).map(lift);
}

/** Anchors and the start of the body, on stems that show where above the floor they are. */
export const anchors: Layer = (input, out) => {
  const color = input.palette.rgba("anchor");
  anchorPoints(input).forEach((point, index) => {
    stem(input, point, out);
    out.point(point, ANCHOR_RADIUS, color, "disc");
    chosenMark(input, index, point, ANCHOR_RADIUS, out);
  });
  if (hasStart(input)) start(input, out);
  lifter(input, out);
};

function hasStart({ handles }: SceneInput): boolean {
  return handles.some(({ id }) => id === START);
}

function start(input: SceneInput, out: DrawList): void {
  const color = input.palette.rgba("anchor");
  const start = lift(input.room.start);
  stem(input, start, out);
  out.point(start, START_RADIUS, color, "disc");
  out.point(start, START_RADIUS + 4, color, "ring");
  chosenMark(input, START, start, START_RADIUS, out);
}

/** A ring around what is under the pointer, and a full one around what is chosen. */
export function chosenMark(
  input: SceneInput,
  thing: Thing,
  point: Vec3,
  radius: number,
  out: DrawList,
): void {
  const { palette, selected, hovered } = input;
  const chosen = selected.includes(thing);
  if (!chosen && thing !== hovered) return;
  out.point(point, radius + 6, palette.rgba("accent"), "ring");
  if (chosen) out.point(point, radius + 3, palette.rgba("accent", 0.35), "disc");
}

function stem({ frame, palette }: SceneInput, point: Vec3, out: DrawList): void {
  if (point[2] === frame.ground) return;
  const foot: Vec3 = [point[0], point[1], frame.ground];
  out.line(point, foot, { width: 1.25, color: palette.rgba("anchor", 0.35), dash: 3 });
  out.point(foot, 2, palette.rgba("anchor", 0.5), "disc");
}

/** The triangle that lifts what is chosen stands above what was chosen last. */
function lifter({ palette, view, lifted }: SceneInput, out: DrawList): void {
  if (!lifted) return;
  const top = heightHandle(view, lifted);
  out.line(lifted, top, { width: 2, color: palette.rgba("accent"), overlay: true });
  out.point(top, 6, palette.rgba("accent"), "triangle");
}

export function anchorLabels(input: SceneInput): Label[] {
  const { room, selected } = input;
  const numbers = anchorPoints(input).map((at, index): Label => ({
    id: `${index}`,
    at,
    text: String(index + 1),
    kind: "anchor",
    strong: selected.includes(index),
  }));
  if (!hasStart(input)) return numbers;
  const at = lift(room.start);
  return [...numbers, { id: START, at, text: "start", kind: "handle", strong: selected.includes(START) }];
}
