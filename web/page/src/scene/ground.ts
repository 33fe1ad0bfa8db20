import { formatNumber } from "../controls/format";
import type { Vec3 } from "./geometry";
import { type Grid, gridOf } from "./grid";
import { thingPoints } from "./handles";
import type { Label, Layer, SceneInput } from "./input";
import type { Pixel, View } from "./view";

/** The grid on the floor with a scale in metres along the sides nearest to the viewer, and one upward. */
export const ground: Layer = (input, out) => {
  const { frame, palette } = input;
  const grid = gridOf(input.view, frame, thingPoints(input).values());
  const { xs, ys } = grid;
  if (xs.length === 0 || ys.length === 0) return;
  const style = { width: 1, color: palette.rgba("grid") };
  const strong = { width: 1.75, color: palette.rgba("line") };
  const [x0, x1, y0, y1] = [xs[0], xs.at(-1)!, ys[0], ys.at(-1)!];
  for (const x of xs) out.line([x, y0, frame.ground], [x, y1, frame.ground], x === 0 ? strong : style);
  for (const y of ys) out.line([x0, y, frame.ground], [x1, y, frame.ground], y === 0 ? strong : style);
  const pole = poleOf(grid, input);
  if (pole) out.line(pole(frame.ground), pole(grid.zs.at(-1)!), style);
};

export function groundLabels(input: SceneInput): Label[] {
  const { frame, view } = input;
  const grid = gridOf(view, frame, thingPoints(input).values());
  const { xs, ys, zs } = grid;
  if (xs.length === 0 || ys.length === 0) return [];
  const at = (x: number, y: number): Vec3 => [x, y, frame.ground];
  const [nearY, farY] = nearFirst(ys, view, (y) => at((xs[0] + xs.at(-1)!) / 2, y));
  const [nearX, farX] = nearFirst(xs, view, (x) => at(x, (ys[0] + ys.at(-1)!) / 2));
  const pole = poleOf(grid, input);
  return [
    ...scaleAlong("x", xs, view, (x) => [at(x, nearY), at(x, farY)]),
    ...scaleAlong("y", ys, view, (y) => [at(nearX, y), at(farX, y)]),
    ...(pole ? uprightScale(zs, view, pole) : []),
  ];
}

/** First and last line, the one nearer to the viewer first: lower on the screen or behind, else on the left. */
function nearFirst(
  values: readonly number[],
  view: View,
  middle: (value: number) => Vec3,
): readonly [number, number] {
  const [a, b] = [values[0], values.at(-1)!];
  const [at, bt] = [view.project(middle(a)), view.project(middle(b))];
  const before = Math.abs(at.y - bt.y) > 1 ? at.y > bt.y : at.x < bt.x;
  const first = Math.min(at.depth, bt.depth) > 0 ? before : at.depth < bt.depth;
  return first ? [a, b] : [b, a];
}

/** The corner of the grid that stands farthest to the left, as a function of the height; none where seen from above. */
function poleOf({ xs, ys, zs }: Grid, { view }: SceneInput): ((height: number) => Vec3) | null {
  if (zs.length < 2 || Math.abs(view.camera.pitch) > 1.2) return null;
  const corners = [xs[0], xs.at(-1)!].flatMap((x) => [ys[0], ys.at(-1)!].map((y): Vec3 => [x, y, zs[0]]));
  const left = corners.reduce((a, b) => (view.project(b).x < view.project(a).x ? b : a));
  return (height) => [left[0], left[1], height];
}

/** Pixels between the end of a line and its number, and that a scale must be long to be told. */
const BEYOND = 13;
const SHORTEST = 60;

/** A number at the near end of each line, or where the line comes into view. One or two say axis and unit. */
function scaleAlong(
  axis: string,
  values: readonly number[],
  view: View,
  line: (value: number) => readonly [Vec3, Vec3],
): Label[] {
  const ends = values.flatMap((value) => {
    const end = visibleEnd(view, ...line(value));
    return end ? [{ value, ...end }] : [];
  });
  if (ends.length < 2) return [];
  const [first, last] = [ends[0].pixel, ends.at(-1)!.pixel];
  if (Math.hypot(last.x - first.x, last.y - first.y) < SHORTEST) return [];
  const count = ends.length;
  const titled = count < 6 ? [count >> 1] : [count >> 2, (3 * count) >> 2];
  return ends.map(({ value, at, offset }, index) => ({
    id: `${axis} ${formatNumber(value)}`,
    at,
    text: titled.includes(index) ? `${axis} = ${formatNumber(value)} m` : formatNumber(value),
    kind: "tick",
    offset,
  }));
}

function uprightScale(zs: readonly number[], view: View, pole: (height: number) => Vec3): Label[] {
  const [low, high] = [view.project(pole(zs[0])), view.project(pole(zs.at(-1)!))];
  if (Math.hypot(high.x - low.x, high.y - low.y) < SHORTEST) return [];
  return zs.map((z, index) => ({
    id: `z ${formatNumber(z)}`,
    at: pole(z),
    text: index === zs.length - 1 ? `z = ${formatNumber(z)} m` : formatNumber(z),
    kind: "tick",
    offset: { x: index === zs.length - 1 ? -30 : -14, y: 0 },
  }));
}

/** CSS pixels from the edge of the view within which no number stands. */
const MARGIN = 26;

interface End {
  readonly at: Vec3;
  readonly pixel: Pixel;
  /** From the end to where its number stands: on along the line. */
  readonly offset: Pixel;
}

/** The first point of a line that is in view, walking from its near end; null where none is. */
function visibleEnd(view: View, near: Vec3, far: Vec3): End | null {
  const { width, height } = view.viewport;
  const shows = ({ x, y, depth }: ReturnType<View["project"]>) =>
    depth > 0 && x >= MARGIN && y >= MARGIN && x <= width - MARGIN && y <= height - MARGIN;
  const at = (share: number): Vec3 => [
    near[0] + share * (far[0] - near[0]),
    near[1] + share * (far[1] - near[1]),
    near[2],
  ];
  const steps = 48;
  for (let i = 0; i <= steps; i++) {
    const pixel = view.project(at(i / steps));
    if (!shows(pixel)) continue;
    const away = view.project(at(Math.min(1, (i + 1) / steps)));
    const length = Math.hypot(pixel.x - away.x, pixel.y - away.y) || 1;
    const reach = i === 0 ? BEYOND : 0;
    return {
      at: at(i / steps),
      pixel,
      offset: { x: ((pixel.x - away.x) / length) * reach, y: ((pixel.y - away.y) / length) * reach },
    };
  }
  return null;
}
