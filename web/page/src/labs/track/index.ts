import type { Lab } from "../../lab";
import { add } from "../../scene/geometry";
import { anchorLabels, anchors } from "../../scene/anchors";
import { ground, groundLabels } from "../../scene/ground";
import Controls from "./Controls.svelte";
import { bodyAxes, estimates, ranges, truth, uncertainty } from "./layers";
import { plots } from "./plots";
import Readout from "./Readout.svelte";
import { describe } from "./sentence";

/** Tracking a rigid body through time: the estimators side by side, with their bounds. */
export const trackLab: Lab = {
  name: "track",
  title: "Track",
  layers: [ground, ranges, uncertainty, truth, estimates, anchors],
  labels: (input) => [
    ...anchorLabels(input),
    ...(input.run ? axisLabels(input, input.run) : []),
    ...groundLabels(input),
  ],
  plots,
  describe,
  Controls,
  Readout,
};

function axisLabels(input: Parameters<Lab["labels"]>[0], run: NonNullable<typeof input.run>) {
  return bodyAxes(input, run).map(({ start, vector }, axis) => ({
    at: add(start, vector),
    text: "xyz"[axis],
    kind: "axis" as const,
  }));
}
