import type { Scenario } from "../../scenario";
import { cross, length, lift, scale, type Vec3 } from "../../scene/geometry";
import type { Label, Layer, SceneInput } from "../../scene/input";
import { facesOf } from "./obstacles";
import { obstacleBoxPart, placementParts, wallPart } from "./parts";
import { downhillOf } from "./placement";
import type { ExploreRun } from "./run";

/** Length of the longest arrow, as a part of the scene's radius. */
const LONGEST = 0.22;

/** Where each anchor should go: against the slope of what the adviser makes small. */
export const downhill: Layer<ExploreRun, Scenario> = ({ run, scenario, frame, palette }, out) => {
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

/** Where anchors may stand and may not, and where the body may be. */
export const boxes: Layer<ExploreRun, Scenario> = ({ scenario, palette, frame }, out) => {
  for (const part of placementParts(scenario)) {
    const style = { width: 1, dash: part.dash, color: palette.rgba(part.token, 0.9) };
    for (const face of facesOf({ kind: "box", ...part.of(scenario) }, frame))
      out.polyline([...face, face[0]], style);
  }
};

/** The name of each box and wall at one of its upper corners. */
export function partLabels({ scenario, frame }: SceneInput<ExploreRun, Scenario>): Label[] {
  const boxes = placementParts(scenario).map((part) => nameOf(part, lift(part.of(scenario).high)));
  const obstacles = scenario.availability.obstacles.map((obstacle, index) => {
    if (obstacle.kind === "box") return nameOf(obstacleBoxPart(index), lift(obstacle.high));
    return nameOf(wallPart(index), facesOf(obstacle, frame)[0].at(-1)!);
  });
  return [...boxes, ...obstacles];
}

function nameOf({ id, name }: { id: string; name: string }, at: Vec3): Label {
  return { id, at, text: name, kind: "name" };
}
