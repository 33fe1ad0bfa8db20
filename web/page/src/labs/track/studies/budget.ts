import { BudgetSum } from "../../../engine";
import type { StudyPage } from "../../../lab";
import type { Run } from "../../../run";
import type { Scenario } from "../../../scenario";
import { keyOf, type StudyPlan } from "../../../state/study.svelte";
import type { BudgetCurves } from "../../../study";
import type { BudgetBlock } from "../../../workers/messages";
import { startBudgetWorker } from "../../../workers/start";
import { budgetPlots, budgetSentence, PAPER } from "./budget-plots";

const PLAN: StudyPlan = { perBlock: 20, firstPicture: 100, most: 1000 };

/** Thirds of a factor of two to either side of the paper's. */
const THRESHOLDS = Float64Array.from({ length: 21 }, (_, index) => PAPER * 2 ** ((index - 12) / 3));
/** Where the threshold is relative to what the filter claims, it is about ten times as large. */
const RELATIVE = THRESHOLDS.map((threshold) => 10 * threshold);

/** What the projections of the ET-KF buy: whether it is switched on does not matter. */
export const budget: StudyPage<Run, BudgetCurves, Scenario> = {
  title: "ET budget",
  always: false,
  subject(scenario) {
    const thresholds = scenario.estimators.threshold.kind === "relative" ? RELATIVE : THRESHOLDS;
    return {
      scenario,
      key: keyOf(withoutThreshold(scenario)),
      plan: PLAN,
      block: (firstTrial, trials): BudgetBlock => ({ scenario, firstTrial, trials, thresholds }),
      openSum: () => new BudgetSum(scenario, thresholds),
    };
  },
  startWorker: startBudgetWorker,
  plots: ({ averages }, scenario) => budgetPlots(averages, scenario),
  told: ({ averages }, scenario) => budgetSentence(averages, scenario),
};

/** All thresholds are studied, whichever is chosen. */
function withoutThreshold(scenario: Scenario): object {
  const { kind } = scenario.estimators.threshold;
  return { ...scenario, estimators: { ...scenario.estimators, enabled: [], threshold: { kind } } };
}
