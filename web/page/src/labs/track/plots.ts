import { DEGREES_PER_RADIAN } from "../../controls/format";
import type { PlotLine, PlotSpec } from "../../plots/spec";
import { type BoundRun, type EstimatorRun, type Run, runsAt } from "../../run";
import type { Scenario } from "../../scenario";
import { MARKS } from "../../theme/palette";

/** The bounds that are shown, most telling first; the unprojected one belongs to the estimator on unprojected ranges. */
const SHOWN_BOUNDS = ["posterior_crb", "posterior_crb_raw", "linear_posterior_crb"];
const NO_EVENTS: readonly number[] = [];
/** Bounds share a colour and are told apart by their dashes; the engine's labels are long, these fit a table. */
const BOUND_LOOKS: Record<string, { short: string; dash: readonly number[] }> = {
  posterior_crb: { short: "posterior CRB", dash: [7, 4] },
  posterior_crb_raw: { short: "posterior CRB, raw", dash: [10, 3, 2, 3] },
  linear_posterior_crb: { short: "linear posterior CRB", dash: [2, 4] },
};

export function shownBounds(run: Run): BoundRun[] {
  const raw = run.estimators.some((estimator) => estimator.name === "eskf-raw");
  const names = SHOWN_BOUNDS.filter((name) => raw || name !== "posterior_crb_raw");
  return names.flatMap((name) => run.bounds.filter((bound) => bound.name === name));
}

export function boundLook(bound: { name: string; label: string }): {
  short: string;
  dash: readonly number[];
} {
  return BOUND_LOOKS[bound.name] ?? { short: bound.label, dash: [7, 4] };
}

export function plots(scenario: Scenario, run: Run): PlotSpec[] {
  const common = { times: run.times };
  return [
    {
      ...common,
      name: "orientation",
      title: "Orientation error",
      unit: "deg",
      lines: [
        ...boundLines(run, (bound) => bound.orientation, DEGREES_PER_RADIAN),
        ...estimatorLines(run, (estimator) => estimator.orientationErrors, DEGREES_PER_RADIAN),
      ],
      threshold: null,
    },
    {
      ...common,
      name: "position",
      title: "Position error",
      unit: "m",
      lines: [
        ...boundLines(run, (bound) => bound.position, 1),
        ...estimatorLines(run, (estimator) => estimator.positionErrors, 1),
      ],
      threshold: null,
    },
    {
      ...common,
      name: "defect",
      title: "Defect ‖QᵀQ − I‖",
      unit: "",
      lines: estimatorLines(run, (estimator) => estimator.defects, 1, true).filter(hasPositive),
      threshold: threshold(scenario),
    },
  ];
}

/** Only an absolute threshold is a line: a relative one moves with the covariance. */
function threshold({ estimators }: Scenario): PlotSpec["threshold"] {
  const { kind, epsilon } = estimators.threshold;
  const shown = kind === "absolute" && estimators.enabled.some((name) => name === "et-kf");
  return shown ? { value: epsilon, label: `ε = ${epsilon}` } : null;
}

function estimatorLines(
  run: Run,
  pick: (estimator: EstimatorRun) => Float64Array,
  factor: number,
  events = false,
): PlotLine[] {
  return run.estimators.map((estimator) => ({
    name: estimator.name,
    label: estimator.label,
    token: estimator.name,
    mark: MARKS[estimator.name] ?? "disc",
    dash: [],
    values: Array.from(pick(estimator), (value, step) => (runsAt(estimator, step) ? value * factor : null)),
    events: events && estimator.name === "et-kf" ? eventSteps(estimator) : NO_EVENTS,
  }));
}

export function eventSteps(estimator: EstimatorRun): number[] {
  return Array.from(estimator.events.keys()).filter((step) => estimator.events[step] === 1);
}

function boundLines(run: Run, pick: (bound: BoundRun) => Float64Array, factor: number): PlotLine[] {
  return shownBounds(run).map((bound) => ({
    name: bound.name,
    label: bound.label,
    token: "bound",
    mark: null,
    dash: boundLook(bound).dash,
    values: Array.from(pick(bound), (value) => value * factor),
    events: NO_EVENTS,
  }));
}

/** Estimators on the rotations have no defect: a line of rounding errors would only stretch the axis. */
function hasPositive(line: PlotLine): boolean {
  return line.values.some((value) => value !== null && value > 1e-9);
}
