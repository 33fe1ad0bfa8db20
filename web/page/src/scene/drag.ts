import { backward } from "./camera";
import { add, dot, scale, sub, type Vec3 } from "./geometry";
import type { Pixel, Ray, View } from "./view";

/** In the plane through the thing, or up and down. */
export type DragMode = "plane" | "height";

/** Below this sine of the angle between ray and ground the ground runs away under the pointer. */
const GRAZING = 0.12;

/**
 * How far a dragged thing is from `start` as the pointer moves, in metres. The grip keeps its offset, so nothing jumps
 * at the start. `limit` is the greatest distance; with a `snap` spacing the coordinates that change become multiples
 * of it.
 */
export function startDrag(
  view: View,
  start: Vec3,
  pointer: Pixel,
  mode: DragMode,
  limit: number,
): (pixel: Pixel, snap: number | null) => Vec3 {
  const solve = mode === "height" ? onVertical(start) : onPlane(view, start);
  const grip = solve(view.ray(pointer)) ?? start;
  return (pixel, snap) => {
    const hit = solve(view.ray(pixel));
    if (hit === null) return [0, 0, 0];
    const shift = sub(hit, grip);
    const distance = Math.hypot(...shift);
    const bounded = distance > limit ? scale(shift, limit / distance) : shift;
    return snap === null ? bounded : snapped(start, bounded, snap);
  };
}

/** Where a tap sends a thing: into its level plane, or the plane that faces the viewer. */
export function destination(view: View, from: Vec3, pixel: Pixel): Vec3 | null {
  return onPlane(view, from)(view.ray(pixel));
}

function snapped(start: Vec3, shift: Vec3, spacing: number): Vec3 {
  const along = (axis: 0 | 1 | 2) =>
    Math.abs(shift[axis]) < 1e-9 * spacing
      ? 0
      : Math.round((start[axis] + shift[axis]) / spacing) * spacing - start[axis];
  return [along(0), along(1), along(2)];
}

/** The level plane through the point; the plane that faces the viewer where the level one is seen edge-on. */
function onPlane(view: View, point: Vec3): (ray: Ray) => Vec3 | null {
  const level = Math.abs(Math.sin(view.camera.pitch)) > GRAZING;
  const normal: Vec3 = level ? [0, 0, 1] : backward(view.camera);
  return (ray) => {
    const slope = dot(ray.direction, normal);
    const along = dot(sub(point, ray.origin), normal) / slope;
    return Number.isFinite(along) && along > 0 ? add(ray.origin, scale(ray.direction, along)) : null;
  };
}

/** The point of the vertical line nearest to the ray. */
function onVertical(point: Vec3): (ray: Ray) => Vec3 | null {
  return ({ origin, direction }) => {
    const between = sub(origin, point);
    const b = direction[2];
    const denominator = 1 - b * b;
    if (denominator < 1e-6) return null;
    const height = (between[2] - b * dot(between, direction)) / denominator;
    return [point[0], point[1], point[2] + height];
  };
}
