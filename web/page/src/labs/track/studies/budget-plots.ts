import { DEGREES_PER_RADIAN, formatNumber, formatReading } from "../../../controls/format";
import type { AxisHandle, AxisMark, PlotAxis, PlotLine, PlotSpec } from "../../../plots/spec";
import type { Scenario } from "../../../scenario";
import type { AlongRun, BudgetCurves, Curve } from "../../../study";
import { NO_EVENTS, PLAIN, withEpsilon } from "../plots";
import { Interpolation } from "./interpolation";

/** The paper’s threshold ([T] Sec. V). */
export const PAPER = 0.15;

const PARTS = [
  { part: "first", label: "step 1", dash: [2, 4], mark: "disc" },
  { part: "all", label: "all", dash: [], mark: "diamond" },
  { part: "last", label: "last", dash: [7, 4], mark: "ring" },
] as const;

/** Error over projections spent, and both over the threshold: one handle in all of them. */
export function budgetPlots(curves: BudgetCurves, scenario: Scenario): PlotSpec[] {
  const spent = new Interpolation(curves.thresholds, curves.projections.value);
  const over = {
    projections: projectionsAxis(curves, spent, scenario),
    threshold: thresholdAxis(curves, scenario),
  };
  const order = Array.from(curves.thresholds.keys()).reverse();
  const bySpending = (curve: Curve): Curve => ({
    value: Float64Array.from(order, (index) => curve.value[index]),
    standardError: Float64Array.from(order, (index) => curve.standardError[index]),
  });
  return [
    {
      ...PLAIN,
      name: "budget",
      title: "Error of Q by projections",
      shortTitle: "Q by projections",
      unit: "",
      x: over.projections,
      lines: linesOf(curves.orientation, 1, bySpending),
    },
    {
      ...PLAIN,
      name: "budget-angle",
      title: "Angle by projections",
      shortTitle: "Angle",
      unit: "deg",
      x: over.projections,
      lines: linesOf(curves.angle, DEGREES_PER_RADIAN, bySpending),
    },
    {
      ...PLAIN,
      name: "threshold",
      title: "Error of Q by threshold",
      shortTitle: "Q by threshold",
      unit: "",
      x: over.threshold,
      lines: linesOf(curves.orientation, 1),
    },
    {
      ...PLAIN,
      name: "spending",
      title: "Projections in a run",
      shortTitle: "Projections",
      unit: "",
      x: over.threshold,
      scale: "linear",
      lines: [line("projections", "projections", curves.projections, 1, { dash: [], mark: "diamond" })],
    },
  ];
}

function thresholdAxis(curves: BudgetCurves, scenario: Scenario): PlotAxis {
  const { epsilon } = scenario.estimators.threshold;
  return {
    name: "threshold ε",
    unit: "",
    values: curves.thresholds,
    scale: "log",
    timed: false,
    now: epsilon,
    handle: handleOf(
      curves,
      scenario,
      (value) => value,
      (place) => place,
    ),
    marks: marksOf(scenario, (value) => value),
  };
}

function projectionsAxis(curves: BudgetCurves, spent: Interpolation, scenario: Scenario): PlotAxis {
  const placeOf = (value: number) => spent.at(value);
  return {
    name: "projections in a run",
    unit: "",
    values: curves.projections.value.toReversed(),
    scale: "linear",
    timed: false,
    now: placeOf(scenario.estimators.threshold.epsilon),
    handle: handleOf(curves, scenario, placeOf, (place) => spent.where(place)),
    marks: marksOf(scenario, placeOf),
  };
}

function handleOf(
  { thresholds }: BudgetCurves,
  scenario: Scenario,
  placeOf: AxisHandle["placeOf"],
  valueAt: AxisHandle["valueAt"],
): AxisHandle {
  const { epsilon } = scenario.estimators.threshold;
  return {
    name: "ET threshold ε",
    value: epsilon,
    least: Number(thresholds[0].toPrecision(2)),
    most: Number(thresholds[thresholds.length - 1].toPrecision(2)),
    label: `ε = ${formatNumber(epsilon)}`,
    token: "et-kf",
    placeOf,
    valueAt,
    edit: (value) => ({
      what: `ET threshold set to ${formatNumber(value)}`,
      scenario: withEpsilon(scenario, value),
    }),
  };
}

/** The paper knows no threshold that moves with what the filter claims. */
function marksOf({ estimators }: Scenario, placeOf: (value: number) => number): AxisMark[] {
  if (estimators.threshold.kind === "relative") return [];
  return [{ place: placeOf(PAPER), label: `paper: ${formatNumber(PAPER)}` }];
}

function linesOf(run: AlongRun, factor: number, arranged = (curve: Curve) => curve): PlotLine[] {
  return PARTS.map(({ part, label, ...look }) => line(part, label, arranged(run[part]), factor, look));
}

function line(
  name: string,
  label: string,
  curve: Curve,
  factor: number,
  look: Pick<PlotLine, "dash" | "mark">,
): PlotLine {
  return {
    name,
    label,
    token: "et-kf",
    ...look,
    values: curve.value.map((value) => value * factor),
    standardErrors: curve.standardError.map((error) => error * factor),
    events: NO_EVENTS,
  };
}

/** What the projections at the chosen threshold buy, against as good as none. */
export function budgetSentence(curves: BudgetCurves, { estimators }: Scenario): string {
  const { epsilon } = estimators.threshold;
  const spent = new Interpolation(curves.thresholds, curves.projections.value);
  const error = (curve: Curve) => new Interpolation(curves.thresholds, curve.value).at(epsilon);
  const { first, last } = curves.orientation;
  const none = first.value[first.value.length - 1];
  const angle = curves.angle.first.value;
  const turned = error(curves.angle.first) / angle[angle.length - 1];
  const same = Math.abs(turned - 1) < 0.01 ? " The angle gains nothing." : "";
  return `ε = ${formatNumber(epsilon)}: ${formatReading(spent.at(epsilon))} projections a run. RMSE of Q at step 1: ${formatReading(error(first))}, without any ${formatReading(none)}; at the last ${formatReading(error(last))}.${same}`;
}
