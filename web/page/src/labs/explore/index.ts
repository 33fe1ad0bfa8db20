import { exploreModule, preset, presets } from "../../engine";
import type { Lab } from "../../lab";
import { rigidBody } from "../../rigid-body/family";
import type { Scenario } from "../../scenario";
import { axisLabels } from "../../rigid-body/layers";
import { anchorLabels, anchors } from "../../scene/anchors";
import { handleLabels, handles as handleMarks } from "../../scene/handles";
import { ground, groundLabels } from "../../scene/ground";
import Controls from "./controls/Panel.svelte";
import { drawings } from "./drawings";
import Designer from "./designer/Designer.svelte";
import { fields, picture } from "./fields";
import { handles } from "./handles";
import { body, bounds, contourLabels, contours, ghosts, mounting, ranges, reading, twin } from "./layers";
import { nextLabels, nextMark } from "./next-layers";
import { nextSearch } from "./next-search.svelte";
import { boxes, downhill, partLabels } from "./placement-layers";
import { obstacles } from "./obstacles";
import Readout from "./Readout.svelte";
import { type ExploreRun, runOf } from "./run";
import { sizePlot } from "./size-plot";
import { describe, note, told } from "./told";

/** Where anchors should stand: the bound as a landscape, and what the geometry cannot see. */
export const lab: Lab<ExploreRun, Scenario> = {
  name: "explore",
  title: "Explore",
  order: 3,
  family: rigidBody,
  load: () => exploreModule.load(),
  presets,
  preset,
  firstPreset: "room",
  compute(scenario) {
    const run = runOf(scenario);
    fields.show(scenario);
    nextSearch.show(scenario);
    return run;
  },
  leave() {
    fields.close();
    nextSearch.close();
  },
  shows: "Anchors, body and the field of its bound in space",
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
    (input, out) => nextMark(nextSearch.place, input, out),
    handleMarks,
    anchors,
    downhill,
  ],
  field: picture,
  found: () => [fields.field, nextSearch.place],
  handles,
  drawings,
  labels: (input) => [
    ...anchorLabels(input),
    ...handleLabels(input),
    ...(input.run ? axisLabels(input, input.run) : []),
    ...nextLabels(nextSearch.place),
    ...partLabels(input),
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
