import { preset, presets, track } from "../../engine";
import type { Lab } from "../../lab";
import type { Run } from "../../run";
import { rigidBody } from "../../rigid-body/family";
import type { Scenario } from "../../scenario";
import { axisLabels } from "../../rigid-body/layers";
import { anchorLabels, anchors } from "../../scene/anchors";
import { ground, groundLabels } from "../../scene/ground";
import Controls from "./controls/Panel.svelte";
import { estimates, ranges, truth } from "./layers";
import { eventSteps, plots } from "./plots";
import { budget } from "./studies/budget";
import { draws } from "./studies/draws";
import { study } from "./study";
import { ghost } from "./ghost";
import Readout from "./Readout.svelte";
import { note, told } from "./told";
import { ellipsoids, fans } from "./uncertainty";
import { describe } from "./sentence";
import { MARKS } from "../../theme/palette";

/** Tracking a rigid body through time: the estimators side by side, with their bounds. */
export const lab: Lab<Run, Scenario> = {
  name: "track",
  title: "Track",
  order: 1,
  family: rigidBody,
  presets,
  preset,
  firstPreset: "room",
  compute: track,
  shows: "Anchors, body, tracks and estimates in space",
  layers: [ground, ranges, ellipsoids, truth, fans, estimates, ghost, anchors],
  labels: (input) => [
    ...anchorLabels(input),
    ...(input.run ? axisLabels(input, input.run) : []),
    ...groundLabels(input),
  ],
  note,
  told,
  plots,
  study,
  studyPages: [budget, draws],
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
