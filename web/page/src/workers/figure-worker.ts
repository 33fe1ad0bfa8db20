/** Computes jobs of the papers' figures. */
import { figureBlock, figuresModule } from "../engine/figures";
import type { FigureJob, Sums } from "./messages";
import { serve } from "./serve";

serve<FigureJob, Sums>(
  figuresModule,
  ({ order, job }) => figureBlock(order, job) as Sums,
  (sums) => [sums.buffer],
);
