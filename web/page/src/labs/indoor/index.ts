import { indoorModule, indoorPresets } from "../../engine";
import type { IndoorScenario } from "../../generated/IndoorScenario";
import type { Lab } from "../../lab";
import { axisLabels } from "../../rigid-body/layers";
import { anchorLabels, anchors } from "../../scene/anchors";
import { ground, groundLabels } from "../../scene/ground";
import Controls from "./controls/Panel.svelte";
import { indoor } from "./family";
import { estimates, ranges, truth, uncertainty } from "./layers";
import { plots } from "./plots";
import Readout from "./Readout.svelte";
import { type IndoorRun, presetOf, runOf } from "./run";
import { study } from "./study";
import { note, told } from "./told";
import { describe } from "./verdict";

/** A body with an IMU among beacons: what filters on SO(3) gain, and from what. */
export const lab: Lab<IndoorRun, IndoorScenario> = {
  name: "indoor",
  title: "Indoor",
  order: 4,
  family: indoor,
  load: () => indoorModule.load(),
  presets: indoorPresets,
  preset: presetOf,
  firstPreset: "indoor-u",
  compute: runOf,
  shows: "Beacons, the body on its path and its estimates in space",
  layers: [ground, ranges, uncertainty, truth, estimates, anchors],
  labels: (input) => [
    ...anchorLabels(input),
    ...(input.run ? axisLabels(input, input.run) : []),
    ...groundLabels(input),
  ],
  note,
  told,
  plots,
  study,
  marks: (run) => [
    {
      label: "fixes",
      one: "Ranges taken",
      token: "range",
      mark: "disc",
      steps: [...run.fixes.keys()].filter((step) => run.fixes[step] === 1),
    },
  ],
  describe,
  Controls,
  Readout,
};
