import { AnchorlessSum, type KinematicsBounds } from "../../engine";
import type { KinematicsReport } from "../../generated/KinematicsReport";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import type { LabStudy } from "../../lab";
import { keyOf, type StudyPlan, type StudySubject } from "../../state/study.svelte";
import type { StampBlock } from "../../workers/messages";
import { startAnchorlessWorker } from "../../workers/start";
import { studyVerdict } from "./findings";
import { type AnchorlessRun, OWN_STAMPS } from "./run";
import { studyPlots } from "./study-plots";

/** The averages at the scenario's own stamps, and the bounds on them. */
export interface StampAverages extends Omit<KinematicsReport, "bounds"> {
  readonly bounds: KinematicsBounds;
}

const FINE: StudyPlan = { perBlock: 20, firstPicture: 40, most: 400 };
/** While one drags. */
const COARSE: StudyPlan = { perBlock: 20, firstPicture: 20, most: 20 };

export const study: LabStudy<AnchorlessRun, StampAverages, KinematicsScenario> = {
  always: false,
  subject: (scenario) => ({
    ...subjectOf(scenario, FINE),
    sketch: { ...subjectOf(scenario, COARSE), key: `sketch ${keyOf(scenario)}` },
  }),
  startWorker: startAnchorlessWorker,
  plots: ({ averages, scenario }) => studyPlots(averages, scenario),
  told: ({ averages }) => studyVerdict(averages),
};

/** Whatever the gauge is, the averages are the same: distances do not see it. */
function subjectOf(
  scenario: KinematicsScenario,
  plan: StudyPlan,
): StudySubject<StampAverages, KinematicsScenario> {
  return {
    scenario,
    key: keyOf(scenario),
    plan,
    block: (firstTrial, trials): StampBlock => ({ scenario, counts: OWN_STAMPS, firstTrial, trials }),
    openSum() {
      const sum = new AnchorlessSum(scenario, OWN_STAMPS);
      return {
        push: (block) => sum.push(block),
        read() {
          const [report] = sum.read();
          return { ...report, bounds: sum.bounds[0] };
        },
        free: () => sum.free(),
      };
    },
  };
}
