import type { Estimate } from "../../generated/Estimate";
import type { KinematicsEstimatorReport } from "../../generated/KinematicsEstimatorReport";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import { type PlotLine, type PlotSpec, timeAxis } from "../../plots/spec";
import { lineLook } from "./estimators";
import { EACH, ONE, PLAIN, timeBounds } from "./plots";
import type { StampAverages } from "./study";

/** The positions over time as averages over trials, beside their bounds. */
export function studyPlots(averages: StampAverages, scenario: KinematicsScenario): PlotSpec[] {
  const common = { ...PLAIN, x: timeAxis(Float64Array.from(averages.instants)) };
  const bounded = { bounds: averages.bounds, scenario };
  return [
    {
      ...common,
      ...ONE,
      title: "Position RMSE, one alignment at t = 0",
      lines: [
        ...timeBounds(bounded, "positions"),
        ...linesOf(averages.estimators, ({ summary }) => summary.positions),
      ],
    },
    {
      ...common,
      ...EACH,
      title: "Position RMSE, aligned at each t",
      lines: [
        ...timeBounds(bounded, "aligned_positions"),
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
