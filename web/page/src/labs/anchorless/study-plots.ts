import type { Estimate } from "../../generated/Estimate";
import type { KinematicsEstimatorReport } from "../../generated/KinematicsEstimatorReport";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import { type PlotLine, type PlotSpec, timeAxis } from "../../plots/spec";
import { lineLook } from "./estimators";
import { boundLines, EACH, ONE, PLAIN } from "./plots";
import type { StampAverages } from "./study";

/** The positions over time as averages over trials, beside their bounds. */
export function studyPlots(averages: StampAverages, { estimators }: KinematicsScenario): PlotSpec[] {
  const { enabled } = estimators;
  const common = { ...PLAIN, x: timeAxis(Float64Array.from(averages.instants)) };
  return [
    {
      ...common,
      ...ONE,
      title: "RMSE, one alignment",
      lines: [
        ...boundLines(averages.bounds, enabled, "positions"),
        ...linesOf(averages.estimators, ({ summary }) => summary.positions),
      ],
    },
    {
      ...common,
      ...EACH,
      title: "RMSE, aligned at each t",
      lines: [
        ...boundLines(averages.bounds, enabled, "aligned_positions"),
        ...linesOf(averages.estimators, ({ summary }) => summary.aligned_positions),
      ],
    },
  ];
}

function linesOf(
  estimators: readonly KinematicsEstimatorReport[],
  pick: (report: KinematicsEstimatorReport) => readonly Estimate[],
): PlotLine[] {
  return estimators
    .filter((report) => pick(report).length > 0)
    .map((report) => ({ ...lineLook(report.name), ...numbersOf(pick(report)) }));
}

export function numbersOf(
  estimates: readonly (Estimate | undefined)[],
): Pick<PlotLine, "values" | "standardErrors"> {
  const numbers = (of: keyof Estimate) => Float64Array.from(estimates, (estimate) => estimate?.[of] ?? NaN);
  return { values: numbers("value"), standardErrors: numbers("standard_error") };
}
