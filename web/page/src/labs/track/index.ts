import { preset, presets, track } from "../../engine";
import type { Lab } from "../../lab";
import type { Run } from "../../run";
import { add, scale } from "../../scene/geometry";
import { anchorLabels, anchors } from "../../scene/anchors";
import { ground, groundLabels } from "../../scene/ground";
import type { Label, SceneInput } from "../../scene/input";
import Controls from "./controls/Panel.svelte";
import { axesOf, axisLength, drawnPosition } from "./drawn";
import { estimates, ranges, truth } from "./layers";
import { eventSteps, plots } from "./plots";
import { studyPlots } from "./study-plots";
import { ghost } from "./ghost";
import Readout from "./Readout.svelte";
import { note, told } from "./told";
import { ellipsoids, fans } from "./uncertainty";
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
  layers: [ground, ranges, ellipsoids, truth, fans, estimates, ghost, anchors],
  labels: (input) => [
    ...anchorLabels(input),
    ...(input.run ? axisLabels(input, input.run) : []),
    ...groundLabels(input),
  ],
  note,
  told,
  plots,
  studyPlots,
  marks: (run) =>
    run.estimators
      .filter((estimator) => estimator.name === "et-kf")
      .map((estimator) => ({
        label: "projections of ET-KF",
        one: "ET-KF projected",
        token: estimator.name,
        mark: MARKS[estimator.name],
        steps: eventSteps(estimator),
      })),
  describe,
  Controls,
  Readout,
};

/** Letters just beyond the tips of the axes. */
function axisLabels(input: SceneInput<Run>, run: Run): Label[] {
  const start = drawnPosition(run, run.truth, input.step, input.frame.magnification);
  const from = input.view.project(start);
  return axesOf(run, run.truth, input.step).map((axis, index) => {
    const at = add(start, scale(axis, axisLength(input)));
    const to = input.view.project(at);
    const share = 11 / Math.max(1, Math.hypot(to.x - from.x, to.y - from.y));
    return {
      id: `axis ${index}`,
      at,
      text: "xyz"[index],
      kind: "axis",
      offset: { x: (to.x - from.x) * share, y: (to.y - from.y) * share },
    };
  });
}
