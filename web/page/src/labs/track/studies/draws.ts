import type { Scenario } from "../../../scenario";
import { DrawList } from "../../../engine";
import type { StudyPage } from "../../../lab";
import type { Run } from "../../../run";
import { keyOf, type StudyPlan } from "../../../state/study.svelte";
import type { AnchorDraws } from "../../../study";
import { startDrawsWorker } from "../../../workers/start";
import { drawsPlots, drawsSentence } from "./draws-plots";

/** No more points than a plot draws. */
const PLAN: StudyPlan = { perBlock: 20, firstPicture: 100, most: 500 };

/** Anchors fixed against anchors drawn anew, for the KF and the UC-KF whichever are switched on. */
export const draws: StudyPage<Run, AnchorDraws, Scenario> = {
  title: "Anchor draws",
  always: false,
  subject: (scenario) => ({
    scenario,
    key: keyOf({ ...scenario, estimators: { ...scenario.estimators, enabled: [] } }),
    plan: PLAN,
    block: (firstTrial, trials) => ({ scenario, firstTrial, trials }),
    openSum: () => new DrawList(scenario),
  }),
  startWorker: startDrawsWorker,
  plots: ({ averages }) => drawsPlots(averages),
  told: ({ averages }) => drawsSentence(averages),
};
