import { preset, presets, track } from "../../engine";
import type { Lab } from "../../lab";
import type { Run } from "../../run";
import { add } from "../../scene/geometry";
import { anchorLabels, anchors } from "../../scene/anchors";
import { ground, groundLabels } from "../../scene/ground";
import type { SceneInput } from "../../scene/input";
import Controls from "./controls/Panel.svelte";
import { bodyAxes, estimates, ranges, truth, uncertainty } from "./layers";
import { eventSteps, plots } from "./plots";
import Readout from "./Readout.svelte";
import { describe } from "./sentence";
import { MARKS } from "../../theme/palette";

/** Tracking a rigid body through time: the estimators side by side, with their bounds. */
export const lab: Lab<Run> = {
  name: "track",
  title: "Track",
  order: 1,
  presets,
  preset,
  firstPreset: "room",
  compute: track,
  layers: [ground, ranges, uncertainty, truth, estimates, anchors],
  labels: (input) => [
    ...anchorLabels(input),
    ...(input.run ? axisLabels(input, input.run) : []),
    ...groundLabels(input),
  ],
  plots,
  marks: (run) =>
    run.estimators
      .filter((estimator) => estimator.name === "et-kf")
      .map((estimator) => ({
        label: "projections of ET-KF",
        token: estimator.name,
        mark: MARKS[estimator.name],
        steps: eventSteps(estimator),
      })),
  describe,
  Controls,
  Readout,
};

function axisLabels(input: SceneInput<Run>, run: Run) {
  return bodyAxes(input, run).map(({ start, vector }, axis) => ({
    at: add(start, vector),
    text: "xyz"[axis],
    kind: "axis" as const,
  }));
}
