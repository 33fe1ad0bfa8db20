import type { Thing } from "../state/things";
import { add, type Vec3 } from "./geometry";
import type { Pixel, View } from "./view";

/** What lies under the pointer: a thing, or the handle that lifts it. */
export interface Hit {
  readonly thing: Thing;
  readonly handle: boolean;
}

/** CSS pixels: half the 24 px target, and the larger one for fingers. */
const REACH = { mouse: 14, touch: 24 };
export const HANDLE_PIXELS = 46;

/** Where the handle that lifts a thing is drawn: a fixed number of pixels above it. */
export function heightHandle(view: View, point: Vec3): Vec3 {
  return add(point, [0, 0, HANDLE_PIXELS * view.metresPerPixel(point)]);
}

/** The nearest thing, or the height handle of the one chosen last, within reach of the pointer. */
export function pick(
  view: View,
  points: ReadonlyMap<Thing, Vec3>,
  lastChosen: Thing | undefined,
  pointer: Pixel & { readonly touch: boolean },
): Hit | null {
  const candidates: [Hit, Vec3][] = [...points].map(([thing, point]) => [{ thing, handle: false }, point]);
  const chosen = lastChosen === undefined ? undefined : points.get(lastChosen);
  if (chosen && handleShows(view))
    candidates.push([{ thing: lastChosen!, handle: true }, heightHandle(view, chosen)]);
  let best: { hit: Hit; distance: number } | null = null;
  for (const [hit, point] of candidates) {
    const at = view.project(point);
    const distance = Math.hypot(at.x - pointer.x, at.y - pointer.y);
    const reach = pointer.touch ? REACH.touch : REACH.mouse;
    if (at.depth > 0 && distance <= reach && distance < (best?.distance ?? Infinity))
      best = { hit, distance };
  }
  return best?.hit ?? null;
}

/** Things inside a rectangle on the screen. */
export function inside(view: View, points: ReadonlyMap<Thing, Vec3>, from: Pixel, to: Pixel): Thing[] {
  const between = (value: number, a: number, b: number) => value >= Math.min(a, b) && value <= Math.max(a, b);
  return [...points.keys()].filter((thing) => {
    const { x, y, depth } = view.project(points.get(thing)!);
    return depth > 0 && between(x, from.x, to.x) && between(y, from.y, to.y);
  });
}

/** Seen from straight above, up points at the viewer and the handle would lie on its thing. */
export function handleShows(view: View): boolean {
  return Math.abs(view.camera.pitch) < 1.2;
}
