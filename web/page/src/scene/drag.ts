import { backward, type Ray, type View } from "./camera";
import { add, dot, scale, sub, type Vec3 } from "./geometry";

/** In the plane through the anchor, or up and down. */
export type DragMode = "plane" | "height";

/** Below this sine of the angle between ray and ground the ground runs away under the pointer. */
const GRAZING = 0.12;

/**
 * Where a dragged point goes as the pointer moves. The grip keeps its offset, so nothing jumps at the start.
 * `limit` is the greatest distance from the start in metres.
 */
export function startDrag(
  view: View,
  start: Vec3,
  pointer: { x: number; y: number },
  mode: DragMode,
  limit: number,
): (x: number, y: number) => Vec3 {
  const solve = mode === "height" ? onVertical(start) : onPlane(view, start);
  const grip = solve(view.ray(pointer.x, pointer.y)) ?? start;
  const offset = sub(start, grip);
  return (x, y) => {
    const hit = solve(view.ray(x, y));
    if (hit === null) return start;
    const moved = sub(add(hit, offset), start);
    const distance = Math.hypot(...moved);
    return add(start, distance > limit ? scale(moved, limit / distance) : moved);
  };
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
