import type { Scenario } from "../../scenario";
import { StudySum } from "../../engine";
import type { LabStudy } from "../../lab";
import type { Run } from "../../run";
import { keyOf, type StudyPlan } from "../../state/study.svelte";
import type { StudyCurves } from "../../study";
import { startStudyWorker } from "../../workers/start";
import { studyPlots } from "./study-plots";
import { verdict } from "./verdicts";

const PLAN: StudyPlan = { perBlock: 20, firstPicture: 200, most: 2000 };

/** The averages of a scenario, and the times of its steps. */
export interface TrackAverages extends StudyCurves {
  readonly times: Float64Array;
}

export const study: LabStudy<Run, TrackAverages, Scenario> = {
  always: false,
  subject: (scenario, { times }) => ({
    scenario,
    key: keyOf(scenario),
    plan: PLAN,
    block: (firstTrial, trials) => ({ scenario, firstTrial, trials }),
    openSum() {
      const sum = new StudySum(scenario);
      return {
        push: (block) => sum.push(block),
        read: () => ({ times, ...sum.read() }),
        free: () => sum.free(),
      };
    },
  }),
  startWorker: startStudyWorker,
  plots: ({ averages }) => studyPlots(averages.times, averages),
  told: ({ averages }) => verdict(averages),
};
