/** Runs blocks of trials. */
import { studyBlock, trackModule } from "../engine/track";
import type { Scenario } from "../scenario";
import type { Block, Sums } from "./messages";
import { serve } from "./serve";

serve<Block<Scenario>, Sums>(
  trackModule,
  ({ scenario, firstTrial, trials }) => studyBlock(scenario, firstTrial, trials) as Sums,
  (sums) => [sums.buffer],
);
