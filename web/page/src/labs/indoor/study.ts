import { IndoorSum } from "../../engine";
import type { IndoorReport } from "../../generated/IndoorReport";
import type { IndoorScenario } from "../../generated/IndoorScenario";
import type { LabStudy } from "../../lab";
import { keyOf, type StudyPlan, type StudySubject } from "../../state/study.svelte";
import { startIndoorWorker } from "../../workers/start";
import type { IndoorRun } from "./run";
import { studyPlots } from "./study-plots";
import { verdict } from "./verdict";

const FINE: StudyPlan = { perBlock: 20, firstPicture: 60, most: 600 };
/** While one drags. */
const COARSE: StudyPlan = { perBlock: 20, firstPicture: 20, most: 20 };

export const study: LabStudy<IndoorRun, IndoorReport, IndoorScenario> = {
  always: false,
  subject: (scenario) => ({
    ...subjectOf(scenario, FINE),
    sketch: { ...subjectOf(scenario, COARSE), key: `sketch ${keyOf(scenario)}` },
  }),
  startWorker: startIndoorWorker,
  plots: ({ averages }) => studyPlots(averages),
  told: ({ averages, scenario }) => verdict(averages, scenario.imu.convention),
};

function subjectOf(scenario: IndoorScenario, plan: StudyPlan): StudySubject<IndoorReport, IndoorScenario> {
  return {
    scenario,
    key: keyOf(scenario),
    plan,
    block: (firstTrial, trials) => ({ scenario, firstTrial, trials }),
    openSum: () => new IndoorSum(scenario),
  };
}
