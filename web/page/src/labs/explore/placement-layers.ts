import type { Region } from "../../generated/Region";
import type { Color } from "../../scene/draw-list";
import { cross, length, lift, scale, type Vec3 } from "../../scene/geometry";
import type { Label, Layer, SceneInput } from "../../scene/input";
import { facesOf } from "./obstacles";
import { downhillOf } from "./placement";
import type { ExploreRun } from "./run";

/** Length of the longest arrow, as a part of the scene's radius. */
const LONGEST = 0.22;

/** Where each anchor should go: against the slope of what the adviser makes small. */
export const downhill: Layer<ExploreRun> = ({ run, scenario, frame, palette }, out) => {
  if (!run || scenario.redraw_anchors !== null) return;
  const style = { width: 2.5, color: palette.rgba("accent"), overlay: true };
  downhillOf(run.advice, scenario.placement.fixed).forEach((arrow, index) => {
    if (arrow === null) return;
    const vector = scale(lift(arrow), LONGEST * frame.radius);
    out.arrow(lift(scenario.anchors[index]), vector, beside(vector), style);
  });
};

/** A vector across another, as long as that one: level, where there is one. */
function beside(vector: Vec3): Vec3 {
  const level = cross([0, 0, 1], vector);
  const across = length(level) > 1e-3 * length(vector) ? level : cross([0, 1, 0], vector);
  return scale(across, length(vector) / length(across));
}

interface NamedBox {
  readonly name: string;
  readonly token: string;
  readonly dash: number;
  readonly region: Region;
}

function boxesOf({ scenario }: SceneInput<ExploreRun>): NamedBox[] {
  const { limits, region, keep_out } = scenario.placement;
  return [
    ...(limits ? [{ name: "anchors within", token: "ink-soft", dash: 0, region: limits }] : []),
    ...(region ? [{ name: "body within", token: "accent", dash: 6, region }] : []),
    ...keep_out.map((box, index) => ({
      name: `keep out ${index + 1}`,
      token: "warning",
      dash: 3,
      region: box,
    })),
  ];
}

/** Where anchors may stand and may not, and where the body may be. */
export const boxes: Layer<ExploreRun> = (input, out) => {
  for (const { token, dash, region } of boxesOf(input)) {
    const color: Color = input.palette.rgba(token, 0.9);
    for (const face of facesOf({ kind: "box", ...region }, input.frame))
      out.polyline([...face, face[0]], { width: 1, dash, color });
  }
};

/** The name of each box at one of its corners. */
export function boxLabels(input: SceneInput<ExploreRun>): Label[] {
  return boxesOf(input).map(({ name, region }) => ({
    id: `box ${name}`,
    at: lift(region.high),
    text: name,
    kind: "tick",
    offset: { x: 0, y: -9 },
  }));
}
