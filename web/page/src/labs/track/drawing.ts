/** Lines drawn by hand: made short enough to be typed, and mapped between a pad and the world. */

type Point = readonly number[];

/**
 * Fewer points whose line stays as near to the drawn one as `most` of them allow, and no nearer than a share `tolerance`
 * of its extent; the ends stay (Douglas-Peucker).
 */
export function simplified(points: readonly Point[], most: number, tolerance = 1e-3): Point[] {
  const kept = new Set([0, points.length - 1]);
  while (kept.size < most) {
    const [index, distance] = farthest(
      points,
      [...kept].sort((one, other) => one - other),
    );
    if (distance <= tolerance * extentOf(points)) break;
    kept.add(index);
  }
  return points.filter((_, index) => kept.has(index));
}

/** The point that lies farthest off the line through those kept. */
function farthest(points: readonly Point[], kept: readonly number[]): [index: number, distance: number] {
  let [index, distance] = [0, -1];
  for (let piece = 1; piece < kept.length; piece++)
    for (let at = kept[piece - 1] + 1; at < kept[piece]; at++) {
      const off = distanceToPiece(points[at], points[kept[piece - 1]], points[kept[piece]]);
      if (off > distance) [index, distance] = [at, off];
    }
  return [index, distance];
}

function distanceToPiece(point: Point, from: Point, to: Point): number {
  const along = to.map((value, axis) => value - from[axis]);
  const offset = point.map((value, axis) => value - from[axis]);
  const squared = along.reduce((sum, value) => sum + value * value, 0);
  const share =
    squared === 0 ? 0 : along.reduce((sum, value, axis) => sum + value * offset[axis], 0) / squared;
  const clamped = Math.min(1, Math.max(0, share));
  return Math.hypot(...offset.map((value, axis) => value - clamped * along[axis]));
}

function extentOf(points: readonly Point[]): number {
  const axes = points[0].map((_, axis) => points.map((point) => point[axis]));
  return Math.max(...axes.map((values) => Math.max(...values) - Math.min(...values)));
}

/** A pad that shows part of the ground from above: x to the right, y up, the same scale on both. */
export interface Pad {
  readonly width: number;
  readonly height: number;
  /** Pixels a metre. */
  readonly scale: number;
  /** The point of the ground in its middle, m. */
  readonly centre: readonly [number, number];
}

/** Of the pad's width and height this part is left free on each side. */
const MARGIN = 0.1;

export function padFor(points: readonly Point[], width: number, height: number): Pad {
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  const [left, right, bottom, top] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const free = 1 - 2 * MARGIN;
  const scale = Math.min((free * width) / (right - left), (free * height) / (top - bottom));
  return {
    width,
    height,
    scale: Number.isFinite(scale) && scale > 0 ? scale : free * height,
    centre: [(left + right) / 2, (bottom + top) / 2],
  };
}

export function padFromWorld({ width, height, scale, centre }: Pad, [x, y]: Point): [number, number] {
  return [width / 2 + scale * (x - centre[0]), height / 2 - scale * (y - centre[1])];
}

/** The point of the ground at a pixel, rounded to what a pixel can tell. */
export function worldFromPad({ width, height, scale, centre }: Pad, [x, y]: Point): [number, number] {
  const step = 10 ** Math.floor(Math.log10(1 / scale));
  const round = (value: number) => Number((Math.round(value / step) * step).toPrecision(12)) + 0;
  return [round(centre[0] + (x - width / 2) / scale), round(centre[1] - (y - height / 2) / scale)];
}
