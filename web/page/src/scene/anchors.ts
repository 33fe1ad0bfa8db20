import type { Label, Layer, SceneInput } from "./input";
import { add, lift, type Vec3 } from "./geometry";
import { handleShows, heightHandle } from "./picking";

export const ANCHOR_RADIUS = 6.5;

/** The anchors that were used: the run's where there is one, for presets that draw them anew. */
export function anchorPoints({ scenario, run }: Pick<SceneInput, "scenario" | "run">): Vec3[] {
  const redrawn = scenario.redraw_anchors !== null && run !== null;
  return (redrawn ? run.anchors : scenario.anchors).map(lift);
}

/** Anchors on stems that show where above the floor they are; the selected one with a ring and a height handle. */
export const anchors: Layer = (input, out) => {
  const { frame, palette, selectedAnchor, hoveredAnchor, view } = input;
  const color = palette.rgba("anchor");
  const stem = { width: 1.25, color: palette.rgba("anchor", 0.35), dash: 3 };
  anchorPoints(input).forEach((point, index) => {
    const foot: Vec3 = [point[0], point[1], frame.ground];
    if (point[2] !== frame.ground) {
      out.line(point, foot, stem);
      out.point(foot, 2, palette.rgba("anchor", 0.5), "disc");
    }
    out.point(point, ANCHOR_RADIUS, color, "disc");
    if (index === hoveredAnchor || index === selectedAnchor)
      out.point(point, ANCHOR_RADIUS + 5, palette.rgba("accent"), "ring");
    if (index !== selectedAnchor || !handleShows(view) || input.scenario.dimension === 2) return;
    const handle = heightHandle(view, point);
    out.line(point, handle, { width: 2, color: palette.rgba("accent"), overlay: true });
    out.point(handle, 6, palette.rgba("accent"), "triangle");
  });
};

export function anchorLabels(input: SceneInput): Label[] {
  return anchorPoints(input).map((point, index) => ({
    at: add(point, [0, 0, 0]),
    text: String(index + 1),
    kind: "anchor",
    strong: index === input.selectedAnchor,
  }));
}
