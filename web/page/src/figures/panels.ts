/** The panels of a figure as plots. */
import type { FigureReport } from "../figure";
import type { Curve } from "../generated/Curve";
import type { Panel } from "../generated/Panel";
import type { PlotLine, PlotSpec } from "../plots/spec";
import { lookOf } from "./looks";

export function plotsOf({ name, panels }: Pick<FigureReport, "name" | "panels">): PlotSpec[] {
  return panels.map((panel) => plotOf(name, panel));
}

function plotOf(figure: string, { name, title, x, y, curves }: Panel): PlotSpec {
  const places = [...new Set(curves.flatMap(({ points }) => points.map((point) => point.x)))];
  const values = Float64Array.from(places).sort();
  return {
    name: `${figure}/${name}`,
    title: `${raised(title)}: ${y.label}`,
    shortTitle: raised(title),
    unit: raised(y.unit),
    x: { name: x.label, unit: raised(x.unit), values, scale: x.scale, timed: false, now: null },
    lines: curves.map((curve) => lineOf(curve, values)),
    bands: [],
    threshold: null,
    scale: y.scale,
    // No share is above 1, whatever its band says.
    ...(y.label.startsWith("share") ? { ceiling: 1 } : {}),
    note: null,
  };
}

/** The crate writes exponents in ASCII. */
export function raised(text: string): string {
  return text.replaceAll("^2", "²").replaceAll("^3", "³");
}

/** Curves need not have a point at every place. An engine's number that is none comes as null. */
function lineOf(curve: Curve, values: Float64Array): PlotLine {
  const at = new Map(curve.points.map(({ x, y }) => [x, y]));
  const numbers = (read: "value" | "standard_error") => values.map((x) => at.get(x)?.[read] ?? NaN);
  const sampled = curve.points.some(({ y }) => y.standard_error > 0);
  return {
    // An estimator and its own covariance may stand in one panel.
    name: curve.kind === "estimator" ? curve.name : `${curve.name} ${curve.kind}`,
    label: curve.label,
    ...lookOf(curve),
    values: numbers("value"),
    standardErrors: sampled ? numbers("standard_error") : null,
    events: [],
  };
}

/** Every curve once, however many panels show it. */
export function keyOf(specs: readonly PlotSpec[]): PlotLine[] {
  const lines = specs.flatMap((spec) => spec.lines);
  return lines.filter((line, index) => lines.findIndex((other) => other.label === line.label) === index);
}
