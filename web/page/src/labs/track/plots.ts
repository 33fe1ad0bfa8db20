import { DEGREES_PER_RADIAN, formatNumber } from "../../controls/format";
import { type PlotLine, type PlotSpec, type Threshold, timeAxis } from "../../plots/spec";
import { type BoundRun, type EstimatorRun, type Run, runsAt } from "../../run";
import type { Scenario } from "../../scenario";
import { MARKS } from "../../theme/palette";
import { neesBands, nisBands } from "../../plots/consistency-bands";

/** The bounds that are shown, most telling first; the unprojected one belongs to the estimator on unprojected ranges. */
const SHOWN_BOUNDS = ["posterior_crb", "posterior_crb_raw", "linear_posterior_crb"];
export const NO_EVENTS: readonly number[] = [];
/** Bounds share a colour and are told apart by their dashes; the engine's labels are long, these fit a table. */
export const BOUND_LOOKS: Record<string, { short: string; dash: readonly number[] }> = {
  posterior_crb: { short: "posterior CRB", dash: [7, 4] },
  posterior_crb_raw: { short: "posterior CRB, raw", dash: [10, 3, 2, 3] },
  linear_posterior_crb: { short: "linear posterior CRB", dash: [2, 4] },
};

interface Named {
  readonly name: string;
  readonly label: string;
}

/** Those of one run, or of a study of many. */
export function shownOf<B extends Named>(estimators: readonly Named[], bounds: readonly B[]): B[] {
  const raw = estimators.some((estimator) => estimator.name === "eskf-raw");
  const names = SHOWN_BOUNDS.filter((name) => raw || name !== "posterior_crb_raw");
  return names.flatMap((name) => bounds.filter((bound) => bound.name === name));
}

export function shownBounds(run: Run): BoundRun[] {
  return shownOf(run.estimators, run.bounds);
}

export function boundLook(bound: Named): { short: string; dash: readonly number[] } {
  return BOUND_LOOKS[bound.name] ?? { short: bound.label, dash: [7, 4] };
}

export function eventSteps(estimator: EstimatorRun): number[] {
  return Array.from(estimator.events.keys()).filter((step) => estimator.events[step] === 1);
}

export function estimatorLook({ name, label }: Named): Omit<PlotLine, "values"> {
  const mark = MARKS[name] ?? "disc";
  return { name, label, token: name, mark, dash: [], standardErrors: null, events: NO_EVENTS };
}

export function boundLineLook(bound: Named): Omit<PlotLine, "values"> {
  const { short, dash } = boundLook(bound);
  const { name } = bound;
  return { name, label: short, token: "bound", mark: null, dash, standardErrors: null, events: NO_EVENTS };
}

export const ORIENTATION = { name: "orientation", shortTitle: "Orientation", unit: "deg" } as const;
export const CONSISTENCY = { name: "nees", shortTitle: "NEES", unit: "" } as const;
export const INNOVATION = { name: "nis", shortTitle: "NIS", unit: "" } as const;
export const POSITION = { name: "position", shortTitle: "Position", unit: "m" } as const;

/** What every plot is unless it says otherwise. */
export const PLAIN = { bands: [], threshold: null, scale: "log", note: null } as const;

export function plots(scenario: Scenario, run: Run): PlotSpec[] {
  const common = { ...PLAIN, x: timeAxis(run.times) };
  return [
    {
      ...common,
      ...ORIENTATION,
      title: "Orientation error",
      lines: [
        ...boundLines(run, (bound) => bound.orientation, DEGREES_PER_RADIAN),
        ...estimatorLines(run, (estimator) => estimator.orientationErrors, DEGREES_PER_RADIAN),
      ],
    },
    {
      ...common,
      ...POSITION,
      title: "Position error",
      lines: [
        ...boundLines(run, (bound) => bound.position, 1),
        ...estimatorLines(run, (estimator) => estimator.positionErrors, 1),
      ],
    },
    {
      ...common,
      name: "defect",
      title: "Defect ‖QᵀQ − I‖",
      shortTitle: "Defect",
      unit: "",
      lines: defectLines(run),
      threshold: threshold(scenario, run),
      note: thresholdNote(scenario),
    },
    {
      ...common,
      ...CONSISTENCY,
      title: "NEES / dof",
      lines: neesLines(run),
      bands: neesBands(run.estimators, 1),
    },
    {
      ...common,
      ...INNOVATION,
      title: "NIS / dof",
      lines: nisLines(run),
      bands: nisBands(run.estimators, 1),
      note: NIS_NOTE,
    },
  ];
}

/** Over its degrees of freedom, so that estimators with different ones can be compared: 1 is right for all. */
function neesLines(run: Run): PlotLine[] {
  return run.estimators.map((estimator) => ({
    ...estimatorLook(estimator),
    values: estimator.nees.map((value, step) =>
      runsAt(estimator, step) ? value / estimator.neesDegreesOfFreedom : NaN,
    ),
  }));
}

function nisLines(run: Run): PlotLine[] {
  return run.estimators.map((estimator) => ({
    ...estimatorLook(estimator),
    values: settledNis(
      estimator.nis.map((value, step) => value / (estimator.nisDegreesOfFreedom[step] || NaN)),
    ),
  }));
}

/** The first ranges only test the guess that one starts from. */
export const NIS_NOTE = "from step 2 on";

/** A step without ranges has no innovation; the first one's is no matter of chance but of how wide the prior is. */
export function settledNis(values: Float64Array): Float64Array {
  return values.map((value, step) => (step === 0 ? NaN : value));
}

function defectLines(run: Run): PlotLine[] {
  const lines = estimatorLines(run, (estimator) => estimator.defects, 1).filter(hasPositive);
  const triggered = run.estimators.find((estimator) => estimator.name === "et-kf");
  const events = triggered ? eventSteps(triggered) : NO_EVENTS;
  return lines.map((line) => (line.name === "et-kf" ? { ...line, events } : line));
}

function triggers({ estimators }: Scenario): boolean {
  return estimators.enabled.some((name) => name === "et-kf");
}

function threshold(scenario: Scenario, run: Run): Threshold | null {
  const { kind, epsilon } = scenario.estimators.threshold;
  // At 0 the line lies below any axis: it is typed away from there.
  if (!triggers(scenario) || kind !== "absolute" || epsilon === 0) return null;
  return {
    name: "ET threshold ε",
    value: epsilon,
    least: 0.001,
    most: 10,
    label: `ε = ${formatNumber(epsilon)}`,
    token: "et-kf",
    heights: new Float64Array(run.steps).fill(epsilon),
    edit: (value) => ({
      what: `ET threshold set to ${formatNumber(value)}`,
      scenario: withEpsilon(scenario, value),
    }),
  };
}

export function withEpsilon(scenario: Scenario, epsilon: number): Scenario {
  const { estimators } = scenario;
  return { ...scenario, estimators: { ...estimators, threshold: { ...estimators.threshold, epsilon } } };
}

function thresholdNote(scenario: Scenario): string | null {
  const { kind, epsilon } = scenario.estimators.threshold;
  if (!triggers(scenario)) return null;
  if (epsilon === 0) return "ε = 0: ET-KF projects at every step.";
  return kind === "relative"
    ? `The threshold ${formatNumber(epsilon)} · √tr P moves with ET-KF’s own P.`
    : null;
}

function estimatorLines(
  run: Run,
  pick: (estimator: EstimatorRun) => Float64Array,
  factor: number,
): PlotLine[] {
  return run.estimators.map((estimator) => ({
    ...estimatorLook(estimator),
    values: pick(estimator).map((value, step) => (runsAt(estimator, step) ? value * factor : NaN)),
  }));
}

function boundLines(run: Run, pick: (bound: BoundRun) => Float64Array, factor: number): PlotLine[] {
  return shownBounds(run).map((bound) => ({
    ...boundLineLook(bound),
    values: pick(bound).map((value) => value * factor),
  }));
}

/** Estimators on the rotations have no defect: a line of rounding errors would only stretch the axis. */
function hasPositive(line: PlotLine): boolean {
  return line.values.some((value) => value > 1e-9);
}
