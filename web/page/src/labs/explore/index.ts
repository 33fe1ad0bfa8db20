import { exploreModule, preset, presets } from "../../engine";
import type { Lab } from "../../lab";
import { axisLabels } from "../../rigid-body/layers";
import { anchorLabels, anchors } from "../../scene/anchors";
import { ground, groundLabels } from "../../scene/ground";
import Controls from "./controls/Panel.svelte";
import Designer from "./designer/Designer.svelte";
import { fields, picture } from "./fields";
import { body, bounds, contourLabels, contours, ghosts, mounting, ranges, reading, twin } from "./layers";
import { nextLabels, nextMark } from "./next-layers";
import { boxes, boxLabels, downhill } from "./placement-layers";
import { obstacles } from "./obstacles";
import Readout from "./Readout.svelte";
import { type ExploreRun, runOf } from "./run";
import { sizePlot } from "./size-plot";
import { describe, note, told } from "./told";

/** Where anchors should stand: the bound as a landscape, and what the geometry cannot see. */
export const lab: Lab<ExploreRun> = {
  name: "explore",
  title: "Explore",
  order: 2,
  family: "rigid body",
  load: () => exploreModule.load(),
  presets,
  preset,
  firstPreset: "room",
  compute(scenario) {
    const run = runOf(scenario);
    fields.show(scenario);
    return run;
  },
  layers: [
    ground,
    contours,
    obstacles,
    boxes,
    ranges,
    bounds,
    mounting,
    body,
    ghosts,
    twin,
    reading,
    nextMark,
    anchors,
    downhill,
  ],
  field: picture,
  labels: (input) => [
    ...anchorLabels(input),
    ...(input.run ? axisLabels(input, input.run) : []),
    ...nextLabels(input),
    ...boxLabels(input),
    ...contourLabels(input),
    ...groundLabels(input),
  ],
  note,
  told,
  plots: ({ field }, { sizes }) => [sizePlot(sizes, field.form)],
  marks: () => [],
  describe,
  Bench: Designer,
  Controls,
  Readout,
};
