import { formatNumber } from "../../controls/format";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import type { PlotAxis, PlotLine, PlotSpec } from "../../plots/spec";
import { boundKinds, boundLook, lineLook } from "./estimators";
import { intervalOf } from "./hints";
import { PLAIN } from "./plots";
import { numbersOf } from "./study-plots";
import type { SweepAverages } from "./sweep";

export const NAMES = ["Position", "Velocity", "Acceleration"];
const UNITS = ["m", "m/s", "m/s²"];

/** Root mean square errors of Y_0, Y_1, … over the number of stamps, beside their bounds. */
export function sweepPlots(averages: SweepAverages, scenario: KinematicsScenario): PlotSpec[] {
  const { estimators } = averages.reports[0];
  const degree = Math.max(0, ...estimators.map(({ summary }) => summary.coefficients.length - 1));
  const x = axis(averages, scenario);
  return Array.from({ length: degree + 1 }, (_, l) => ({
    ...PLAIN,
    name: `anchorless-y${l}`,
    title: `${NAMES[l] ?? `Y${l}`} RMSE, Y${l}`,
    shortTitle: NAMES[l] ?? `Y${l}`,
    unit: UNITS[l] ?? `m/s^${l}`,
    x,
    lines: [...boundLines(averages, scenario, l), ...estimatorLines(averages, l)],
  }));
}

/** Along it lies the scenario's own number of stamps, and a press sets it. */
function axis({ reports }: SweepAverages, scenario: KinematicsScenario): PlotAxis {
  const { stamps } = scenario;
  return {
    name: "K",
    unit: "",
    values: Float64Array.from(reports, (report) => report.stamps),
    scale: "log",
    timed: false,
    now: stamps.kind === "regular" ? stamps.count : stamps.times.length,
    edit(value) {
      const [first, last] = intervalOf(scenario);
      const count = Math.max(1, Math.round(value));
      return {
        what: `K set to ${formatNumber(count)}`,
        scenario: { ...scenario, stamps: { kind: "regular", first, last, count } },
      };
    },
  };
}

function estimatorLines({ reports }: SweepAverages, l: number): PlotLine[] {
  return reports[0].estimators
    .map(({ name }, index): PlotLine => ({
      ...lineLook(name),
      ...numbersOf(reports.map(({ estimators }) => estimators[index].summary.coefficients[l])),
    }))
    .filter(({ values }) => values.some(Number.isFinite));
}

function boundLines({ bounds }: SweepAverages, { estimators }: KinematicsScenario, l: number): PlotLine[] {
  return boundKinds(estimators.enabled)
    .map((kind): PlotLine => ({
      ...boundLook(kind),
      values: Float64Array.from(bounds, (each) => each[kind].coefficients[l] ?? NaN),
      standardErrors: null,
    }))
    .filter(({ values }) => values.some(Number.isFinite));
}
