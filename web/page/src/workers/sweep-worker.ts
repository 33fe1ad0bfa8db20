/** Runs blocks of trials at each noise of a sweep. */
import { localizationBlock, localizeModule } from "../engine/localize";
import type { Sums, SweepBlock } from "./messages";
import { serve } from "./serve";

serve<SweepBlock, Sums>(
  localizeModule,
  (block) => localizationBlock(block) as Sums,
  (sums) => [sums.buffer],
);
