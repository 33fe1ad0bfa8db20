import { DEGREES_PER_RADIAN } from "../../controls/format";
import type { IndoorFilterReport } from "../../generated/IndoorFilterReport";
import type { IndoorReport } from "../../generated/IndoorReport";
import type { IndoorSummary } from "../../generated/IndoorSummary";
import type { PlotAxis, PlotLine, PlotSpec } from "../../plots/spec";
import { lineLook } from "./filters";
import { PLAIN } from "./plots";

/** A curve needs no more places than this. */
const MOST_PLACES = 240;

/** How many of the trials have an error no larger than so much: a curve a filter, over the errors of all. */
export function distributionPlots(report: IndoorReport): PlotSpec[] {
  return [
    plot(report, "position error", "m", 1, ({ position_distribution }) => position_distribution),
    plot(
      report,
      "orientation error",
      "deg",
      DEGREES_PER_RADIAN,
      ({ angle_distribution }) => angle_distribution,
    ),
  ];
}

function plot(
  { filters }: IndoorReport,
  name: string,
  unit: string,
  factor: number,
  pick: (summary: IndoorSummary) => readonly number[],
): PlotSpec {
  const errors = filters.map(({ summary }) => pick(summary).map((error) => error * factor));
  const values = placesOf(errors);
  const x: PlotAxis = { name, unit, values, scale: "log", timed: false, now: null };
  const word = name.split(" ")[0];
  return {
    ...PLAIN,
    name: `indoor-cdf-${word}`,
    title: `CDF of ${word}`,
    shortTitle: `CDF, ${word}`,
    unit: "%",
    scale: "linear",
    ceiling: 100,
    x,
    lines: filters.map(({ name: filter }, index): PlotLine => ({
      ...lineLook(filter),
      ...shares(errors[index], values, trialsOf(filters[index])),
    })),
  };
}

/** Where the curves are drawn: at the errors themselves, all or every so many. */
function placesOf(errors: readonly (readonly number[])[]): Float64Array {
  const all = [...new Set(errors.flat())].sort((a, b) => a - b);
  const step = Math.max(1, Math.ceil(all.length / MOST_PLACES));
  return Float64Array.from(all.filter((_, index) => index % step === 0 || index === all.length - 1));
}

/** All trials of a filter: one that failed stays below no error, so that its curve does not reach the top. */
function trialsOf({ summary }: IndoorFilterReport): number {
  return summary.trials + summary.failures;
}

/** The share of the trials with an error no larger, in per cent, with the standard error of a share. */
export function shares(
  errors: readonly number[],
  places: Float64Array,
  trials: number,
): Pick<PlotLine, "values" | "standardErrors"> {
  let count = 0;
  const values = places.map((place) => {
    while (count < errors.length && errors[count] <= place) count += 1;
    return (100 * count) / trials;
  });
  const standardErrors = values.map((share) => Math.sqrt((share * (100 - share)) / trials));
  return { values, standardErrors };
}
