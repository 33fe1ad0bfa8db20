/** Draws anchors anew and runs a trial over each draw. */
import { drawsBlock } from "../engine/studies";
import { trackModule } from "../engine/track";
import type { Scenario } from "../scenario";
import type { Block, Sums } from "./messages";
import { serve } from "./serve";

serve<Block<Scenario>, Sums>(
  trackModule,
  ({ scenario, firstTrial }) => drawsBlock(scenario, firstTrial) as Sums,
  (sums) => [sums.buffer],
);
