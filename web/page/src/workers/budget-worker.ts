/** Runs blocks of trials at each threshold of the ET-KF. */
import { budgetBlock } from "../engine/studies";
import { trackModule } from "../engine/track";
import type { BudgetBlock, Sums } from "./messages";
import { serve } from "./serve";

serve<BudgetBlock, Sums>(
  trackModule,
  ({ scenario, thresholds, firstTrial }) => budgetBlock(scenario, thresholds, firstTrial) as Sums,
  (sums) => [sums.buffer],
);
