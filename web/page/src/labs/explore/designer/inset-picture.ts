import { hullOf } from "../../../scene/hull";
import { lift, niceBelow, scale, type Vec3 } from "../../../scene/geometry";
import type { Pixel, View } from "../../../scene/view";

/** What the inset draws, in CSS pixels of it. */

export interface AxisArrow {
  readonly name: string;
  readonly tip: Pixel;
  /** Where its letter stands. */
  readonly letter: Pixel;
}

/** An axis that is seen end on has no arrow. */
const LEAST_ARROW = 14;
const LETTER_GAP = 9;

export function axisArrows(view: View, dimension: number, length: number): AxisArrow[] {
  const origin = view.project([0, 0, 0]);
  return [0, 1, 2].slice(0, dimension).flatMap((axis) => {
    const tip = view.project(scale(unit(axis), length));
    const arrow = Math.hypot(tip.x - origin.x, tip.y - origin.y);
    if (arrow < LEAST_ARROW) return [];
    return [{ name: "xyz"[axis], tip, letter: beyond(origin, tip, LETTER_GAP) }];
  });
}

function unit(axis: number): Vec3 {
  return [Number(axis === 0), Number(axis === 1), Number(axis === 2)];
}

/** A number stands outward of its sensor; over the origin it stands to the upper right. */
export function numberPlace(view: View, sensor: Pixel, gap: number): Pixel {
  const origin = view.project([0, 0, 0]);
  const away = Math.hypot(sensor.x - origin.x, sensor.y - origin.y);
  return away > 1
    ? beyond(origin, sensor, gap)
    : { x: sensor.x + gap / Math.SQRT2, y: sensor.y - gap / Math.SQRT2 };
}

function beyond(from: Pixel, to: Pixel, pixels: number): Pixel {
  const share = pixels / Math.max(1, Math.hypot(to.x - from.x, to.y - from.y));
  return { x: to.x + (to.x - from.x) * share, y: to.y + (to.y - from.y) * share };
}

/** The edges and faces of the body as the paths of two elements. */
export function outlineOf(sensors: readonly (readonly number[])[], at: readonly Pixel[]): Outline {
  const { edges, faces } = hullOf(sensors.map(lift));
  const corner = (index: number) => `${round(at[index].x)} ${round(at[index].y)}`;
  return {
    edges: edges.map(([i, j]) => `M${corner(i)}L${corner(j)}`).join(""),
    faces: faces.map(([i, j, k]) => `M${corner(i)}L${corner(j)}L${corner(k)}Z`).join(""),
  };
}

export interface Outline {
  readonly edges: string;
  readonly faces: string;
}

/** A dot for each point: strokes of no length with round ends. */
export function dotsOf(view: View, points: readonly Vec3[]): string {
  return points
    .map((point) => view.project(point))
    .map(({ x, y }) => `M${round(x)} ${round(y)}h0`)
    .join("");
}

/** Lines with round distances along both edges, for views along an axis; the origin is on two of them. */
export function gridOf(view: View, reach: number): string {
  const { width, height } = view.viewport;
  const pixels = niceBelow(reach / 2) / view.metresPerPixel(view.camera.target);
  const origin = view.project([0, 0, 0]);
  const from = (middle: number) => middle - pixels * Math.floor(middle / pixels);
  let path = "";
  for (let x = from(origin.x); x <= width; x += pixels) path += `M${round(x)} 0V${height}`;
  for (let y = from(origin.y); y <= height; y += pixels) path += `M0 ${round(y)}H${width}`;
  return path;
}

function round(value: number): number {
  return Math.round(value * 10) / 10;
}
