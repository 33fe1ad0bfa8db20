import { advise, EngineTrap, explore } from "../../engine";
import type { Advice } from "../../generated/Advice";
import type { Exploration } from "../../generated/Exploration";
import type { LabRun } from "../../lab";
import type { Scenario } from "../../scenario";
import { type SizeCurves, sizeCurves } from "./size-curves";

/** One moment: what its ranges show of the pose that the body starts in. */
export interface ExploreRun extends LabRun {
  readonly exploration: Exploration;
  readonly advice: Advice;
  readonly sizes: SizeCurves;
}

export function runOf(scenario: Scenario): ExploreRun {
  const { dimension, anchors, start } = scenario;
  return {
    dimension,
    steps: 1,
    times: Float64Array.of(0),
    anchors,
    truth: {
      orientations: Float64Array.from(start.orientation.flat()),
      positions: Float64Array.from(start.position),
    },
    exploration: explore(scenario),
    advice: adviceOn(scenario),
    sizes: sizeCurves(scenario),
  };
}

/** Where the adviser has nothing to tell, the bounds are still shown: its sentence stands in for the value. */
function adviceOn(scenario: Scenario): Advice {
  try {
    return advise(scenario);
  } catch (error) {
    if (!(error instanceof Error) || error instanceof EngineTrap) throw error;
    return { unit: "m", value: null, cause: error.message, gradient: [] };
  }
}
