import type { Label, Layer, SceneInput } from "./input";
import type { Vec3 } from "./geometry";
import { formatNumber } from "../controls/format";

/** The grid on the floor, with its scale in metres along two sides. */
export const ground: Layer = ({ frame, palette }, out) => {
  const style = { width: 1, color: palette.rgba("grid") };
  const strong = { width: 1.75, color: palette.rgba("line") };
  const { xs, ys } = gridLines({ frame });
  for (const x of xs)
    out.line([x, ys[0], frame.ground], [x, ys[ys.length - 1], frame.ground], x === 0 ? strong : style);
  for (const y of ys)
    out.line([xs[0], y, frame.ground], [xs[xs.length - 1], y, frame.ground], y === 0 ? strong : style);
};

/** Scale numbers on the two sides nearest to the viewer. */
export function groundLabels({ frame, view }: SceneInput): Label[] {
  const { xs, ys } = gridLines({ frame });
  const margin = 0.3 * frame.spacing;
  const nearY = view.eye[1] < frame.centre[1] ? ys[0] - margin : ys[ys.length - 1] + margin;
  const nearX = view.eye[0] < frame.centre[0] ? xs[0] - margin : xs[xs.length - 1] + margin;
  const tick = (at: Vec3, value: number, axis: string): Label => ({
    at,
    text: value === 0 ? `${axis} 0 m` : formatNumber(value),
    kind: "tick",
  });
  return [
    ...xs.map((x) => tick([x, nearY, frame.ground], x, "x")),
    ...ys.map((y) => tick([nearX, y, frame.ground], y, "y")),
  ];
}

function gridLines({ frame }: Pick<SceneInput, "frame">): { xs: number[]; ys: number[] } {
  const along = (axis: 0 | 1) => {
    const first = Math.floor((frame.centre[axis] - frame.reach[axis]) / frame.spacing);
    const last = Math.ceil((frame.centre[axis] + frame.reach[axis]) / frame.spacing);
    return Array.from({ length: last - first + 1 }, (_, i) => (first + i) * frame.spacing);
  };
  return { xs: along(0), ys: along(1) };
}
