import { backward, type Camera, type Direction, halfHeight, pan, rightward, upward } from "./camera";
import { add, dot, scale, sub, type Vec3 } from "./geometry";
import { View, type Viewport } from "./view";

/** Share of the half width or height that the outermost points may take. */
const FILL = 0.84;

const STEP_BACK = 1.04;
const MOST_STEPS_BACK = 20;

/** CSS pixels at the edges of the view that are kept clear. */
export interface Inset {
  readonly left: number;
  readonly top: number;
  readonly bottom: number;
}

/** Looks at points from the given direction, with their middle in the middle, just far enough to see them all. */
export function fit(
  points: readonly Vec3[],
  direction: Direction,
  viewport: Viewport,
  inset: Inset = { left: 0, top: 0, bottom: 0 },
): Camera {
  const { yaw, pitch, orthographic } = direction;
  const facing: Camera = { target: [0, 0, 0], yaw, pitch, orthographic, distance: 1 };
  const axes = [rightward(facing), upward(facing), backward(facing)];
  const middles = axes.map((axis) => middle(points.map((point) => dot(point, axis))));
  const target = axes.map((axis, i) => scale(axis, middles[i])).reduce(add);
  const height = Math.max(1, viewport.height);
  const clear = Math.max(1, viewport.height - inset.top - inset.bottom);
  const tangent = (FILL * halfHeight(1) * clear) / height;
  const aspect = (viewport.width - inset.left) / clear;
  const needed = points.map((point) => {
    const [right, up, back] = axes.map((axis) => dot(sub(point, target), axis));
    return Math.max(Math.abs(right) / (tangent * aspect), Math.abs(up) / tangent) + (orthographic ? 0 : back);
  });
  const shifted = (distance: number) =>
    pan({ ...facing, target, distance }, inset.left / 2, (inset.top - inset.bottom) / 2, viewport);
  let distance = Math.max(1e-3, ...needed);
  // Aside of what is kept clear, near points move farther than the middle: a few steps back bring them in.
  for (
    let i = 0;
    i < MOST_STEPS_BACK && !allInside(points, new View(shifted(distance), viewport), inset);
    i++
  )
    distance *= STEP_BACK;
  return shifted(distance);
}

function allInside(points: readonly Vec3[], view: View, inset: Inset): boolean {
  const { width, height } = view.viewport;
  const [marginX, marginY] = [
    ((1 - FILL) / 2) * (width - inset.left) - 1,
    ((1 - FILL) / 2) * (height - inset.top - inset.bottom) - 1,
  ];
  return points.every((point) => {
    const { x, y } = view.project(point);
    const across = x >= inset.left + marginX && x <= width - marginX;
    return across && y >= inset.top + marginY && y <= height - inset.bottom - marginY;
  });
}

const middle = (values: readonly number[]): number => (Math.min(...values) + Math.max(...values)) / 2;
