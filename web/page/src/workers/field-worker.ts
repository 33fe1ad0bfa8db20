/** Computes rows of fields. */
import { exploreModule, fieldRows } from "../engine/explore";
import type { FieldRows, RowValues } from "./messages";
import { serve } from "./serve";

serve<FieldRows, RowValues>(
  exploreModule,
  ({ scenario, resolution, first, count }) => fieldRows(scenario, resolution, first, count) as RowValues,
  (values) => [values.buffer],
);
