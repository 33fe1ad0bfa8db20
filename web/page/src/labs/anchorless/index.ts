import { anchorlessModule, anchorlessPresets } from "../../engine";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import type { Lab } from "../../lab";
import { anchorLabels, anchors } from "../../scene/anchors";
import { ground, groundLabels } from "../../scene/ground";
import { handleLabels, handles as handleMarks } from "../../scene/handles";
import Controls from "./controls/Panel.svelte";
import { anchorless } from "./family";
import { describe } from "./findings";
import { handles } from "./handles";
import { arrows, distances, estimates, motion, uncertainty } from "./layers";
import { plots } from "./plots";
import Readout from "./Readout.svelte";
import { type AnchorlessRun, presetOf, runOf } from "./run";
import { study } from "./study";
import { sweep } from "./sweep";
import { note, told } from "./told";

/** Mobile nodes without anchors: what distances alone say of their motion, and what accelerometers add. */
export const lab: Lab<AnchorlessRun, KinematicsScenario> = {
  name: "anchorless",
  title: "Anchorless",
  order: 5,
  family: anchorless,
  load: () => anchorlessModule.load(),
  presets: anchorlessPresets,
  preset: presetOf,
  firstPreset: "kinematics-paper",
  compute: runOf,
  shows: "Mobile nodes, their arrows and their estimates in space",
  layers: [ground, distances, uncertainty, motion, arrows, anchors, estimates, handleMarks],
  uncertainty: {
    position:
      "Ellipses hold 95 % of the positions and of the arrows' tips that the bounds allow, drawn larger as the errors are",
  },
  handles,
  labels: (input) => [...anchorLabels(input), ...handleLabels(input), ...groundLabels(input)],
  note,
  told,
  plots,
  study,
  studyPages: [sweep],
  marks: () => [],
  describe,
  Controls,
  Readout,
};
