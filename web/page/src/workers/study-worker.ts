/** Runs blocks of trials. */
import { studyBlock, trackModule } from "../engine/track";
import type { Block, Sums } from "./messages";
import { serve } from "./serve";

serve<Block, Sums>(
  trackModule,
  ({ scenario, firstTrial, trials }) => studyBlock(scenario, firstTrial, trials) as Sums,
  (sums) => [sums.buffer],
);
