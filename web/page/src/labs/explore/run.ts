import { explore } from "../../engine";
import type { Exploration } from "../../generated/Exploration";
import type { LabRun } from "../../lab";
import type { Scenario } from "../../scenario";

/** One moment: what its ranges show of the pose that the body starts in. */
export interface ExploreRun extends LabRun {
  readonly exploration: Exploration;
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
  };
}
