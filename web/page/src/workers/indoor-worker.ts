/** Runs blocks of trials of an indoor scenario. */
import { indoorBlock, indoorModule } from "../engine/indoor";
import type { IndoorScenario } from "../generated/IndoorScenario";
import type { Block, Sums } from "./messages";
import { serve } from "./serve";

serve<Block<IndoorScenario>, Sums>(
  indoorModule,
  ({ scenario, firstTrial }) => indoorBlock(scenario, firstTrial) as Sums,
  (sums) => [sums.buffer],
);
