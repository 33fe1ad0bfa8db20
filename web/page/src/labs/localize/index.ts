import { localizeModule, preset, presets } from "../../engine";
import type { Lab } from "../../lab";
import { rigidBody } from "../../rigid-body/family";
import type { Scenario } from "../../scenario";
import { axisLabels } from "../../rigid-body/layers";
import { anchorLabels, anchors } from "../../scene/anchors";
import { ground, groundLabels } from "../../scene/ground";
import Controls from "./controls/Panel.svelte";
import { body, clouds, estimates, mirrored, ranges } from "./layers";
import { sweepPlots } from "./plots";
import Readout from "./Readout.svelte";
import { type LocalizeRun, runOf } from "./run";
import { study, ZETAS } from "./sweep";
import { describe, note, told } from "./told";

/** The pose from the ranges of one epoch: clouds of estimates, and their errors over the noise. */
export const lab: Lab<LocalizeRun, Scenario> = {
  name: "localize",
  title: "Localize",
  order: 2,
  family: rigidBody,
  load: () => localizeModule.load(),
  presets,
  preset,
  firstPreset: "localization-paper",
  compute: runOf,
  shows: "Anchors, body and clouds of its estimates in space",
  layers: [ground, ranges, body, estimates, mirrored, clouds, anchors],
  uncertainty: {
    position: "Dots are the positions that each estimator finds in other trials",
    orientation:
      "Dots are the tips of the axes that each estimator finds in other trials; rings, of a mirrored body",
  },
  labels: (input) => [
    ...anchorLabels(input),
    ...(input.run ? axisLabels(input, input.run) : []),
    ...groundLabels(input),
  ],
  note,
  told,
  plots: (scenario, run) => sweepPlots(ZETAS, null, scenario, run),
  study,
  marks: () => [],
  describe,
  Controls,
  Readout,
};
