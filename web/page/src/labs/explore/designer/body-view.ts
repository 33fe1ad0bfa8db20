import type { Sensors } from "../../../rigid-body/body-edits";
import {
  backward,
  type Camera,
  DIRECTIONS,
  type Direction,
  halfHeight,
  rightward,
  upward,
} from "../../../scene/camera";
import { add, scale, type Vec3 } from "../../../scene/geometry";
import { type Pixel, View, type Viewport } from "../../../scene/view";

/** The body alone, in its own frame, around its origin, by parallel rays of sight. */

export const SIDES = ["front", "side", "top"] as const;
export type Side = (typeof SIDES)[number];

export function directionOf(side: Side | "space" | "plane"): Direction {
  return { ...DIRECTIONS[side], orthographic: true };
}

/** The side that is seen, null where the view is turned otherwise. */
export function sideOf({ yaw, pitch }: Direction): Side | null {
  const same = (side: Side) => DIRECTIONS[side].yaw === yaw && DIRECTIONS[side].pitch === pitch;
  return SIDES.find(same) ?? null;
}

/** Metres from the origin that are in sight: they grow in steps of the root of two, so that small changes move nothing. */
export function reachOf(sensors: Sensors): number {
  const radius = Math.max(...sensors.map((sensor) => Math.hypot(...sensor))) || 0.1;
  return 1.25 * 2 ** (Math.ceil(2 * Math.log2(radius) - 1e-9) / 2);
}

export function bodyView(direction: Direction, reach: number, viewport: Viewport): View {
  const { width, height } = viewport;
  const distance = (reach * height) / Math.min(width, height) / halfHeight(1);
  const camera: Camera = { ...direction, target: [0, 0, 0], distance };
  return new View(camera, viewport);
}

/** The way in the view plane that so many pixels stand for, m. */
export function shiftOf(view: View, from: Pixel, to: Pixel): Vec3 {
  const metres = view.metresPerPixel(view.camera.target);
  return add(
    scale(rightward(view.camera), (to.x - from.x) * metres),
    scale(upward(view.camera), (from.y - to.y) * metres),
  );
}

const KEYS: Readonly<Record<string, readonly ["right" | "up" | "near", 1 | -1]>> = {
  ArrowRight: ["right", 1],
  ArrowLeft: ["right", -1],
  ArrowUp: ["up", 1],
  ArrowDown: ["up", -1],
  PageUp: ["near", 1],
  PageDown: ["near", -1],
};

/** The body's axis along which a key moves: the one nearest to its direction in the view; null for other keys. */
export function axisOfKey(
  key: string,
  direction: Direction,
  dimension: number,
): { readonly axis: number; readonly sign: number } | null {
  if (!(key in KEYS)) return null;
  const [towards, sign] = KEYS[key];
  const camera = { ...direction, target: [0, 0, 0], distance: 1 } as const;
  const free = new Set([0, 1, 2].slice(0, dimension));
  for (const [name, vector] of [
    ["right", rightward(camera)],
    ["up", upward(camera)],
    ["near", backward(camera)],
  ] as const) {
    if (free.size === 0) return null;
    const axis = [...free].reduce((best, next) =>
      Math.abs(vector[next]) > Math.abs(vector[best]) ? next : best,
    );
    if (name === towards) return { axis, sign: sign * (vector[axis] < 0 ? -1 : 1) };
    free.delete(axis);
  }
  return null;
}
