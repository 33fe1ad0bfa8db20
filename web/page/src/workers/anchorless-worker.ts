/** Runs blocks of trials of a kinematics scenario, at each of some numbers of stamps. */
import { anchorlessBlock, anchorlessModule } from "../engine/anchorless";
import type { StampBlock, Sums } from "./messages";
import { serve } from "./serve";

serve<StampBlock, Sums>(
  anchorlessModule,
  ({ scenario, counts, firstTrial }) => anchorlessBlock(scenario, counts, firstTrial) as Sums,
  (sums) => [sums.buffer],
);
