import type { LabRun } from "../lab";
import type { Scenario } from "../scenario";
import { placeOf, type Thing } from "../state/things";
import type { DrawList } from "./draw-list";
import { lift, type Vec3 } from "./geometry";
import type { Label, Layer, SceneInput } from "./input";
import { handleShows, heightHandle } from "./picking";

const ANCHOR_RADIUS = 6.5;
const START_RADIUS = 4;

/** The anchors that were used: the run's where there is one, for presets that draw them anew. */
export function anchorPoints({ scenario, run }: { scenario: Scenario; run: LabRun | null }): Vec3[] {
  const redrawn = scenario.redraw_anchors !== null && run !== null;
  return (redrawn ? run.anchors : scenario.anchors).map(lift);
}

/** Everything that can be chosen, and where it is drawn. */
export function thingPoints(input: { scenario: Scenario; run: LabRun | null }): Map<Thing, Vec3> {
  return new Map<Thing, Vec3>([
    ...anchorPoints(input).entries(),
    ["start", lift(placeOf(input.scenario, "start"))],
  ]);
}

/** Anchors and the start of the body, on stems that show where above the floor they are. */
export const anchors: Layer = (input, out) => {
  const { palette, selected, hovered } = input;
  for (const [thing, point] of thingPoints(input)) {
    const radius = thing === "start" ? START_RADIUS : ANCHOR_RADIUS;
    stem(input, point, out);
    out.point(point, radius, palette.rgba("anchor"), "disc");
    if (thing === "start") out.point(point, radius + 4, palette.rgba("anchor"), "ring");
    const chosen = selected.includes(thing);
    if (!chosen && thing !== hovered) continue;
    out.point(point, radius + 6, palette.rgba("accent"), "ring");
    if (chosen) out.point(point, radius + 3, palette.rgba("accent", 0.35), "disc");
  }
  handle(input, out);
};

function stem({ frame, palette }: SceneInput, point: Vec3, out: DrawList): void {
  if (point[2] === frame.ground) return;
  const foot: Vec3 = [point[0], point[1], frame.ground];
  out.line(point, foot, { width: 1.25, color: palette.rgba("anchor", 0.35), dash: 3 });
  out.point(foot, 2, palette.rgba("anchor", 0.5), "disc");
}

/** The triangle that lifts what is chosen stands above what was chosen last. */
function handle(input: SceneInput, out: DrawList): void {
  const { palette, view, selected, scenario } = input;
  const point = thingPoints(input).get(selected.at(-1) ?? -1);
  if (!point || !handleShows(view) || scenario.dimension === 2) return;
  const top = heightHandle(view, point);
  out.line(point, top, { width: 2, color: palette.rgba("accent"), overlay: true });
  out.point(top, 6, palette.rgba("accent"), "triangle");
}

export function anchorLabels(input: SceneInput): Label[] {
  return [...thingPoints(input)].map(([thing, at]) => ({
    id: `${thing}`,
    at,
    text: thing === "start" ? "start" : String(thing + 1),
    kind: thing === "start" ? "start" : "anchor",
    strong: input.selected.includes(thing),
  }));
}
