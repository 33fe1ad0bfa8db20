import { DEGREES_PER_RADIAN } from "../../controls/format";
import type { Estimate } from "../../generated/Estimate";
import type { IndoorFilterReport } from "../../generated/IndoorFilterReport";
import type { IndoorReport } from "../../generated/IndoorReport";
import type { IndoorStepSummary } from "../../generated/IndoorStepSummary";
import { type PlotLine, type PlotSpec, timeAxis } from "../../plots/spec";
import { distributionPlots } from "./distribution";
import { lineLook } from "./filters";
import { bandsFor, CONSISTENCY, ORIENTATION, PLAIN, POSITION, STRETCH, stretchLines } from "./plots";

/** The plots of one run as averages over trials, and how the errors of the trials are distributed. */
export function studyPlots(report: IndoorReport): PlotSpec[] {
  const common = { ...PLAIN, x: timeAxis(Float64Array.from(report.times)) };
  const { trials } = report;
  const filters = report.filters.filter(({ summary }) => summary.trials > 0);
  return [
    { ...common, ...POSITION, title: "Position RMSE", lines: linesOf(filters, (step) => step.position) },
    {
      ...common,
      ...ORIENTATION,
      title: "Orientation RMSE",
      lines: linesOf(filters, (step) => step.angle, DEGREES_PER_RADIAN),
    },
    ...distributionPlots(report),
    {
      ...common,
      ...STRETCH,
      title: "Mean singular values of R",
      lines: filters.flatMap(({ name, summary: { steps } }) =>
        stretchLines(
          name,
          numbersOf(steps, (step) => step.largest_singular_value),
          numbersOf(steps, (step) => step.smallest_singular_value),
        ),
      ),
    },
    {
      ...common,
      ...CONSISTENCY,
      title: "Mean NEES / dof",
      lines: linesOf(filters, (step) => step.nees),
      bands: bandsFor(Math.max(1, trials)),
    },
  ];
}

type Pick = (step: IndoorStepSummary) => Estimate;

function linesOf(filters: readonly IndoorFilterReport[], pick: Pick, factor = 1): PlotLine[] {
  return filters.map(({ name, summary }) => ({
    ...lineLook(name),
    ...numbersOf(summary.steps, pick, factor),
  }));
}

function numbersOf(steps: readonly IndoorStepSummary[], pick: Pick, factor = 1) {
  const numbers = (of: keyof Estimate) =>
    Float64Array.from(steps, (step) => (pick(step)[of] ?? NaN) * factor);
  return { values: numbers("value"), standardErrors: numbers("standard_error") };
}
