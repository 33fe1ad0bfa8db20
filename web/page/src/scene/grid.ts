import type { Frame } from "./frame";
import { niceBelow, type Vec3 } from "./geometry";
import type { View } from "./view";

/** The lines on the floor: as fine as the view can show, as far as the scene goes. */
export interface Grid {
  /** Metres from line to line: 1, 2 or 5 times a power of ten. */
  readonly spacing: number;
  readonly xs: readonly number[];
  readonly ys: readonly number[];
  /** Heights of the vertical scale; none in the plane. */
  readonly zs: readonly number[];
}

/** CSS pixels that a cell in the middle of the view is wide at most. */
const CELL_PIXELS = 90;
/** Halves of the view that lines reach from its middle, where the scene goes on. */
const VIEWS = 1.6;

/**
 * The grid covers the frame and the points that left it, so that it grows with what is dragged and stays otherwise;
 * seen from near it covers the surroundings of what is looked at.
 */
export function gridOf(view: View, frame: Frame, points: Iterable<Vec3>): Grid {
  const { camera, viewport } = view;
  const { low, high } = boxOf(frame, points);
  const foot: Vec3 = [camera.target[0], camera.target[1], frame.ground];
  const metresPerPixel = Math.max(view.metresPerPixel(camera.target), view.metresPerPixel(foot));
  const spacing = niceBelow(CELL_PIXELS * metresPerPixel);
  const reach = (VIEWS / 2) * metresPerPixel * Math.max(viewport.width, viewport.height);
  const along = (axis: 0 | 1 | 2, first: number) =>
    multiples(
      spacing,
      Math.max(first, Math.floor((camera.target[axis] - reach) / spacing)),
      Math.min(Math.ceil(high[axis] / spacing), Math.ceil((camera.target[axis] + reach) / spacing)),
    );
  return {
    spacing,
    xs: along(0, Math.floor(low[0] / spacing)),
    ys: along(1, Math.floor(low[1] / spacing)),
    zs: frame.flat ? [] : along(2, Math.ceil(frame.ground / spacing)),
  };
}

function boxOf(frame: Frame, points: Iterable<Vec3>): { low: Vec3; high: Vec3 } {
  const all = [...frame.whole, ...points];
  const coordinate = (axis: 0 | 1 | 2) => all.map((point) => point[axis]);
  const low = (axis: 0 | 1 | 2) => Math.min(...coordinate(axis));
  const high = (axis: 0 | 1 | 2) => Math.max(...coordinate(axis));
  return { low: [low(0), low(1), low(2)], high: [high(0), high(1), high(2)] };
}

/** `spacing` times each whole number from `first` to `last`. */
function multiples(spacing: number, first: number, last: number): number[] {
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => (first + i) * spacing);
}
