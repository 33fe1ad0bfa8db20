import { DEGREES_PER_RADIAN, formatReading } from "../../../controls/format";
import { quantiles } from "../../../engine";
import type { PlotAxis, PlotLine, PlotSpec } from "../../../plots/spec";
import type { AnchorDraws, Deviations, RunErrors } from "../../../study";
import { MARKS } from "../../../theme/palette";
import { NO_EVENTS, ORIENTATION, PLAIN, POSITION } from "../plots";

type Quantity = keyof RunErrors;

const SERIES = [
  { of: "bound", name: "posterior_crb", label: "posterior CRB", token: "bound", mark: "ring", dash: [7, 4] },
  { of: "filter", name: "kf", label: "KF", token: "kf", mark: MARKS["kf"], dash: [] },
  { of: "constrained", name: "uc-kf", label: "UC-KF", token: "uc-kf", mark: MARKS["uc-kf"], dash: [] },
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
      note: `${conditions(draws)} ${errors(draws, "angle", DEGREES_PER_RADIAN, "°")}`,
    },
    {
      ...PLAIN,
      ...POSITION,
      name: "draws-position",
      title: "Position by anchor condition",
      x,
      lines: linesOf(draws, "position", 1, order),
      note: errors(draws, "position", 1, "\u00a0m"),
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
  return { name: "condition of the anchors", unit: "", values, scale: "log", now, marks };
}

function linesOf(
  draws: AnchorDraws,
  quantity: Quantity,
  factor: number,
  order: readonly number[],
): PlotLine[] {
  const plain = { standardErrors: null, events: NO_EVENTS };
  const points = SERIES.map(({ of, dash: _, ...look }): PlotLine => {
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

const SHARES = [0.5, 0.95, 0.99];

function conditions({ conditions, halfWidth }: AnchorDraws): string {
  const told = quantiles(conditions, SHARES).map(formatReading);
  return `Drawn in a cube of ±${formatReading(halfWidth)} m. Condition: median ${told[0]}, 95 % below ${told[1]}, 99 % below ${told[2]}.`;
}

function errors(draws: AnchorDraws, quantity: Quantity, factor: number, unit: string): string {
  const told = ({ fixed, redrawn }: Deviations, label: string) => {
    const [middle, most] = quantiles(redrawn[quantity], [0.5, 0.95]).map((value) =>
      formatReading(value * factor),
    );
    return `${label} median ${middle}${unit}, 95 % below ${most}${unit} (fixed ${formatReading(median(fixed[quantity]) * factor)}${unit})`;
  };
  return `${told(draws.filter, "KF:")}; ${told(draws.constrained, "UC-KF:")}.`;
}
