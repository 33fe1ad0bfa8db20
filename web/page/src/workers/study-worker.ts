/** Runs blocks of trials. */
import { studyBlock } from "../engine";
import type { Block, Sums } from "./messages";
import { serve } from "./serve";

serve<Block, Sums>(
  ({ scenario, firstTrial, trials }) => studyBlock(scenario, firstTrial, trials) as Sums,
  (sums) => [sums.buffer],
);
