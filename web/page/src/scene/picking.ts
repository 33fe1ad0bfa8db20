import type { Thing } from "../state/things";
import { add, type Vec3 } from "./geometry";
import type { Pixel, View } from "./view";

/** What lies under the pointer: a thing, or the triangle that lifts it. */
export interface Hit {
  readonly thing: Thing;
  readonly lifter: boolean;
}

/** CSS pixels: half the 24 px target, and the larger one for fingers. */
const REACH = { mouse: 14, touch: 24 };
export const LIFTER_PIXELS = 46;
/** CSS pixels that a handle must be nearer than an anchor to be taken before it. */
const YIELDS = 8;

/** Where the triangle that lifts a thing is drawn: a fixed number of pixels above it. */
export function heightHandle(view: View, point: Vec3): Vec3 {
  return add(point, [0, 0, LIFTER_PIXELS * view.metresPerPixel(point)]);
}

/** What can be taken, and what of it was chosen last. */
export interface Pickable {
  readonly points: ReadonlyMap<Thing, Vec3>;
  readonly last: Thing | undefined;
  /** Where the last one is, if it can be lifted. */
  readonly lifted: Vec3 | null;
}

/**
 * Everything within reach of the pointer, nearest first. Handles yield to anchors, but not the one that was chosen last.
 */
export function pickAll(
  view: View,
  { points, last, lifted }: Pickable,
  pointer: Pixel & { readonly touch: boolean },
): Hit[] {
  const candidates: [Hit, Vec3][] = [...points].map(([thing, point]) => [{ thing, lifter: false }, point]);
  if (last !== undefined && lifted)
    candidates.push([{ thing: last, lifter: true }, heightHandle(view, lifted)]);
  const reach = pointer.touch ? REACH.touch : REACH.mouse;
  return candidates
    .map(([hit, point]) => ({ hit, at: view.project(point) }))
    .map(({ hit, at }) => ({ hit, depth: at.depth, away: Math.hypot(at.x - pointer.x, at.y - pointer.y) }))
    .filter(({ depth, away }) => depth > 0 && away <= reach)
    .map(({ hit, away }) => ({ hit, cost: away + disadvantage(hit, last) }))
    .sort((a, b) => a.cost - b.cost)
    .map(({ hit }) => hit);
}

function disadvantage({ thing, lifter }: Hit, last: Thing | undefined): number {
  if (lifter || typeof thing === "number") return 0;
  return thing === last ? -1 : YIELDS;
}

/** Things inside a rectangle on the screen. */
export function inside(view: View, points: ReadonlyMap<Thing, Vec3>, from: Pixel, to: Pixel): Thing[] {
  const between = (value: number, a: number, b: number) => value >= Math.min(a, b) && value <= Math.max(a, b);
  return [...points.keys()].filter((thing) => {
    const { x, y, depth } = view.project(points.get(thing)!);
    return depth > 0 && between(x, from.x, to.x) && between(y, from.y, to.y);
  });
}

/** Seen from straight above, up points at the viewer and the triangle would lie on its thing. */
export function lifterShows(view: View): boolean {
  return Math.abs(view.camera.pitch) < 1.2;
}
