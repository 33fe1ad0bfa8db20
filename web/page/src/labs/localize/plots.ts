import { DEGREES_PER_RADIAN, formatNumber } from "../../controls/format";
import type { Estimate } from "../../generated/Estimate";
import type { LocalizationReport } from "../../generated/LocalizationReport";
import type { SnapshotBoundSummary } from "../../generated/SnapshotBoundSummary";
import type { SnapshotSummary } from "../../generated/SnapshotSummary";
import type { PlotAxis, PlotLine, PlotSpec, ScaleKind } from "../../plots/spec";
import { levelBelow, medianRange, noiseBelow } from "../../rigid-body/noise-level";
import type { Scenario } from "../../scenario";
import { BOUND_LOOKS, boundsFor, lookOf } from "./localizers";
import type { LocalizeRun } from "./run";

/** What a plot shows of each localizer, and of each bound where there is one. */
interface Figure {
  readonly name: string;
  readonly title: string;
  readonly shortTitle: string;
  readonly unit: string;
  readonly scale: ScaleKind;
  readonly factor: number;
  readonly note?: string;
  /** False: its standard errors are no band around it. */
  readonly spread?: boolean;
  of(summary: SnapshotSummary): Estimate | null;
  bound?(summary: SnapshotBoundSummary): Estimate | null;
}

const FIGURES: readonly Figure[] = [
  {
    name: "localize-orientation",
    title: "Orientation RMSE",
    shortTitle: "Orientation",
    unit: "deg",
    scale: "log",
    factor: DEGREES_PER_RADIAN,
    of: (summary) => summary.rms_angle,
    bound: (summary) => summary.angle,
  },
  {
    name: "localize-position",
    title: "Position RMSE",
    shortTitle: "Position",
    unit: "m",
    scale: "log",
    factor: 1,
    of: (summary) => summary.rmse_position,
    bound: (summary) => summary.position,
  },
  {
    name: "localize-q",
    title: "RMSE(Q)",
    shortTitle: "RMSE(Q)",
    unit: "",
    scale: "log",
    factor: 1,
    of: (summary) => summary.rmse_orientation,
    bound: (summary) => summary.orientation,
  },
  {
    name: "localize-reflections",
    title: "Mirrored bodies",
    shortTitle: "Reflections",
    unit: "%",
    scale: "linear",
    factor: 100,
    of: (summary) => summary.reflection_rate,
  },
  {
    name: "localize-bias-q",
    title: "Bias of Q",
    shortTitle: "Bias",
    unit: "",
    scale: "log",
    factor: 1,
    note: "Less than RMSE(Q) ÷ √trials is chance.",
    of: (summary) => summary.bias_orientation,
    spread: false,
  },
  {
    name: "localize-iterations",
    title: "Iterations",
    shortTitle: "Iterations",
    unit: "",
    scale: "linear",
    factor: 1,
    of: (summary) => summary.iterations,
  },
  {
    name: "localize-sensors",
    title: "Sensor RMSE",
    shortTitle: "Sensors",
    unit: "m",
    scale: "log",
    factor: 1,
    of: (summary) => summary.rmse_sensors,
    bound: (summary) => summary.sensors,
  },
];

/** The plots over the sweep; without a report their frames. */
export function sweepPlots(
  zetas: Float64Array,
  report: LocalizationReport | null,
  scenario: Scenario,
  run: LocalizeRun,
): PlotSpec[] {
  const x = axis(zetas, scenario, run);
  return FIGURES.map(({ name, title, shortTitle, unit, scale, note, ...figure }) => ({
    name,
    title,
    shortTitle,
    unit,
    scale,
    x,
    bands: [],
    threshold: null,
    note: note ?? null,
    lines: report ? [...boundLines(report, figure), ...localizerLines(report, figure)] : [],
  }));
}

/** Along it lies the scenario's own noise, and a press sets it. */
function axis(values: Float64Array, scenario: Scenario, run: LocalizeRun): PlotAxis {
  const range = medianRange({ ...run, anchors: scenario.anchors });
  return {
    name: "signal to noise ζ",
    unit: "dB",
    values,
    scale: "linear",
    timed: false,
    now: levelBelow(scenario.noise, range),
    edit(value) {
      const level = Math.round(value);
      const noise = noiseBelow(scenario.noise.kind, range, level);
      return { what: `ζ set to ${formatNumber(level)} dB`, scenario: { ...scenario, noise } };
    },
  };
}

function localizerLines(
  report: LocalizationReport,
  { of, factor, spread = true }: Pick<Figure, "of" | "factor" | "spread">,
): PlotLine[] {
  return report.estimators
    .map(({ name, points }): PlotLine => {
      const { label, token, mark } = lookOf(name);
      return { name, label, token, mark, dash: [], events: [], ...curve(points.map(of), factor, spread) };
    })
    .filter(hasNumbers);
}

function boundLines(
  report: LocalizationReport,
  { bound, factor }: Pick<Figure, "bound" | "factor">,
): PlotLine[] {
  if (!bound) return [];
  const enabled = report.estimators.map(({ name }) => name);
  return boundsFor(enabled)
    .flatMap((wanted) => report.bounds.filter(({ name }) => name === wanted))
    .map(({ name, points }): PlotLine => ({
      name,
      ...BOUND_LOOKS[name],
      token: "bound",
      mark: null,
      events: [],
      ...curve(points.map(bound), factor, true),
    }))
    .filter(hasNumbers);
}

function curve(
  estimates: readonly (Estimate | null)[],
  factor: number,
  spread: boolean,
): Pick<PlotLine, "values" | "standardErrors"> {
  const numbers = (of: keyof Estimate) =>
    Float64Array.from(estimates, (estimate) => (estimate?.[of] ?? NaN) * factor);
  return { values: numbers("value"), standardErrors: spread ? numbers("standard_error") : null };
}

function hasNumbers({ values }: PlotLine): boolean {
  return values.some(Number.isFinite);
}
