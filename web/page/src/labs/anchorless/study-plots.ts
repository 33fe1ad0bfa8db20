import type { Estimate } from "../../generated/Estimate";
import type { KinematicsEstimatorReport } from "../../generated/KinematicsEstimatorReport";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import { type PlotLine, type PlotSpec, timeAxis } from "../../plots/spec";
import { boundKinds, boundLook, lineLook } from "./estimators";
import { EACH, ONE, PLAIN } from "./plots";
import type { StampAverages } from "./study";

/** The positions over time as averages over trials, beside their bounds. */
export function studyPlots(averages: StampAverages, scenario: KinematicsScenario): PlotSpec[] {
  const common = { ...PLAIN, x: timeAxis(Float64Array.from(averages.instants)) };
  return [
    {
      ...common,
      ...ONE,
      title: "RMSE, one alignment",
      lines: [
        ...boundLines(averages, scenario, "positions"),
        ...linesOf(averages.estimators, ({ summary }) => summary.positions),
      ],
    },
    {
      ...common,
      ...EACH,
      title: "RMSE, aligned at each t",
      lines: [
        ...boundLines(averages, scenario, "aligned_positions"),
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

function boundLines(
  { bounds }: StampAverages,
  { estimators }: KinematicsScenario,
  of: "positions" | "aligned_positions",
): PlotLine[] {
  return boundKinds(estimators.enabled)
    .filter((kind) => bounds[kind][of].length > 0)
    .map((kind) => ({
      ...boundLook(kind),
      values: Float64Array.from(bounds[kind][of]),
      standardErrors: null,
    }));
}
