import { DEGREES_PER_RADIAN, formatReading } from "../../../controls/format";
import { quantiles } from "../../../engine";
import type { PlotAxis, PlotLine, PlotSpec } from "../../../plots/spec";
import type { AnchorDraws, Deviations, RunErrors } from "../../../study";
import { MARKS } from "../../../theme/palette";
import { NO_EVENTS, ORIENTATION, PLAIN, POSITION } from "../plots";

type Quantity = keyof RunErrors;

const SERIES = [
  { of: "bound", name: "posterior_crb", label: "posterior CRB", token: "bound", mark: "cross" },
  { of: "filter", name: "kf", label: "KF", token: "kf", mark: MARKS["kf"] },
  { of: "constrained", name: "uc-kf", label: "UC-KF", token: "uc-kf", mark: MARKS["uc-kf"] },
] as const;

/** Errors of each draw over the condition of its anchors; levels where the fixed anchors have them. */
export function drawsPlots(draws: AnchorDraws): PlotSpec[] {
  const order = orderOf(draws.conditions);
  const x = conditionAxis(draws, order);
  return [
    {
      ...PLAIN,
      ...ORIENTATION,
      name: "draws-orientation",
      title: "Orientation by anchor condition",
      x,
      lines: linesOf(draws, "angle", DEGREES_PER_RADIAN, order),
    },
    {
      ...PLAIN,
      ...POSITION,
      name: "draws-position",
      title: "Position by anchor condition",
      x,
      lines: linesOf(draws, "position", 1, order),
    },
  ];
}

/** Draws by increasing condition; those in a plane have none. */
function orderOf(conditions: Float64Array): number[] {
  const there = Array.from(conditions.keys()).filter((draw) => Number.isFinite(conditions[draw]));
  return there.toSorted((one, other) => conditions[one] - conditions[other]);
}

function conditionAxis({ conditions, fixedCondition }: AnchorDraws, order: readonly number[]): PlotAxis {
  const values = Float64Array.from(order, (draw) => conditions[draw]);
  const flat = !Number.isFinite(fixedCondition);
  const now = flat ? Infinity : fixedCondition;
  const marks = [{ place: now, label: flat ? "fixed anchors: in a plane" : "fixed anchors" }];
  return { name: "condition of the anchors", unit: "", values, scale: "log", timed: false, now, marks };
}

function linesOf(
  draws: AnchorDraws,
  quantity: Quantity,
  factor: number,
  order: readonly number[],
): PlotLine[] {
  const plain = { standardErrors: null, events: NO_EVENTS };
  const points = SERIES.map(({ of, ...look }): PlotLine => {
    const values = draws[of].redrawn[quantity];
    return {
      ...look,
      ...plain,
      dash: [],
      points: true,
      values: Float64Array.from(order, (draw) => values[draw] * factor),
    };
  });
  const levels = SERIES.map(({ of, name, label, token }): PlotLine => {
    const level = median(draws[of].fixed[quantity]) * factor;
    const values = new Float64Array(order.length).fill(level);
    return {
      ...plain,
      name: `${name}-fixed`,
      label: `${label}, fixed anchors`,
      token,
      mark: null,
      dash: [7, 4],
      values,
    };
  });
  return [...points, ...levels];
}

function median(numbers: Float64Array): number {
  return quantiles(numbers, [0.5])[0];
}

/** How the draws are conditioned, and what they do to whom, beside the fixed anchors (dashed in the plots). */
export function drawsSentence(draws: AnchorDraws): string {
  const [middle, most, nearlyAll] = quantiles(draws.conditions, [0.5, 0.95, 0.99]).map(formatReading);
  return [
    `Drawn within ±${formatReading(draws.halfWidth)}\u00a0m. Condition: median ${middle}, 95\u00a0% below ${most}, 99\u00a0% below ${nearlyAll}`,
    `fixed ${formatReading(draws.fixedCondition)} (dashed). Median and 95\u00a0%: KF ${errors(draws.filter, "angle", DEGREES_PER_RADIAN, "°")}`,
    `UC-KF ${errors(draws.constrained, "angle", DEGREES_PER_RADIAN, "°")}`,
    `position ${errors(draws.constrained, "position", 1, "\u00a0m")}.`,
  ].join("; ");
}

function errors({ fixed, redrawn }: Deviations, quantity: Quantity, factor: number, unit: string): string {
  const told = (value: number) => formatReading(value * factor);
  const [middle, most] = quantiles(redrawn[quantity], [0.5, 0.95]);
  return `${told(middle)} and ${told(most)}${unit} (fixed ${told(median(fixed[quantity]))}${unit})`;
}
