import type { View } from "./camera";
import { add, type Vec3 } from "./geometry";

/** What lies under the pointer. */
export type Hit = { readonly kind: "anchor" | "height"; readonly index: number };

/** CSS pixels: half the 24 px target, and the larger one for fingers. */
const REACH = { mouse: 14, touch: 24 };
export const HANDLE_PIXELS = 46;

/** Where the handle that lifts an anchor is drawn: a fixed number of pixels above it. */
export function heightHandle(view: View, anchor: Vec3): Vec3 {
  return add(anchor, [0, 0, HANDLE_PIXELS * view.metresPerPixel(anchor)]);
}

/** The nearest anchor, or the height handle of the selected one, within reach of the pointer. */
export function pick(
  view: View,
  anchors: readonly Vec3[],
  selected: number | null,
  pointer: { x: number; y: number; touch: boolean },
): Hit | null {
  const reach = pointer.touch ? REACH.touch : REACH.mouse;
  const candidates: { hit: Hit; point: Vec3 }[] = anchors.map((point, index) => ({
    hit: { kind: "anchor", index },
    point,
  }));
  if (selected !== null && selected < anchors.length && handleShows(view)) {
    const point = heightHandle(view, anchors[selected]);
    candidates.push({ hit: { kind: "height", index: selected }, point });
  }
  let best: { hit: Hit; distance: number } | null = null;
  for (const { hit, point } of candidates) {
    const at = view.project(point);
    const distance = Math.hypot(at.x - pointer.x, at.y - pointer.y);
    if (at.depth > 0 && distance <= reach && distance < (best?.distance ?? Infinity))
      best = { hit, distance };
  }
  return best?.hit ?? null;
}

/** Seen from straight above, up points at the viewer and the handle would lie on its anchor. */
export function handleShows(view: View): boolean {
  return Math.abs(view.camera.pitch) < 1.2;
}
