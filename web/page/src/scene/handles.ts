import { type Handle, START } from "../state/handles";
import type { Thing } from "../state/things";
import { anchorPoints, chosenMark } from "./anchors";
import type { Frame } from "./frame";
import { lift, type Vec3 } from "./geometry";
import type { Box } from "./labels";
import type { Label, Layer, SceneInput } from "./input";

const RADIUS = 4.5;
/** What sets a handle off from the lines and the field behind it, CSS pixels. */
const HALO = 2;

/** Everything that can be chosen, and where it is drawn: anchors first, which are taken before handles. */
export function thingPoints(
  things: Pick<SceneInput, "room" | "run" | "handles" | "frame">,
): Map<Thing, Vec3> {
  const { handles, frame } = things;
  return new Map<Thing, Vec3>([
    ...anchorPoints(things).entries(),
    ...handles.map((handle): [Thing, Vec3] => [handle.id, pointOf(handle, frame)]),
  ]);
}

function pointOf({ place, level }: Handle, { flat, ground }: Frame): Vec3 {
  return flat || place.length === 3 ? lift(place) : [place[0], place[1], level ?? ground];
}

/** The lab's own handles. */
export const handles: Layer = (input, out) => {
  const { palette, frame } = input;
  for (const handle of input.handles) {
    if (handle.id === START) continue;
    const point = pointOf(handle, frame);
    out.point(point, RADIUS + HALO, palette.rgba("scene"), handle.mark);
    out.point(point, RADIUS, palette.rgba(handle.token), handle.mark);
    chosenMark(input, handle.id, point, RADIUS, out);
  }
};

/** What no text may cover. */
export function handleBoxes({ handles, frame, view }: SceneInput): Box[] {
  const half = RADIUS + HALO;
  return handles
    .map((handle) => view.project(pointOf(handle, frame)))
    .filter(({ depth }) => depth > 0)
    .map(({ x, y }) => ({ x, y, halfWidth: half, halfHeight: half }));
}

/** The handles that one deals with, by their names. */
export function handleLabels({ handles, frame, selected, hovered }: SceneInput): Label[] {
  return handles
    .filter(({ id }) => id !== START && (selected.includes(id) || id === hovered))
    .map((handle) => ({
      id: handle.id,
      at: pointOf(handle, frame),
      text: handle.name,
      kind: "handle",
      strong: selected.includes(handle.id),
    }));
}
