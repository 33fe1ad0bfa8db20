import { formatNumber, formatReading } from "../../controls/format";
import type { RangeForm } from "../../generated/RangeForm";
import type { PlotLine, PlotSpec } from "../../plots/spec";
import type { SizeCurves } from "./size-curves";

/** How large the body must be for what orientation, as a plot. */

const FORMS: readonly { form: RangeForm; dash: readonly number[] }[] = [
  { form: "projected", dash: [7, 4] },
  { form: "raw", dash: [10, 3, 2, 3] },
];
/** Slopes nearer than this to -1 are that of small bodies. */
const SLOPE_TOLERANCE = 0.02;

/** `form` is the one whose slope is told. */
export function sizePlot(curves: SizeCurves, form: RangeForm): PlotSpec {
  const { size, sizes } = curves;
  const lines = FORMS.map(({ form: name, dash }): PlotLine => {
    const look = { label: `${name} ranges`, token: "bound", mark: null, dash };
    return { name, ...look, values: curves[name], standardErrors: null, events: [] };
  });
  return {
    name: "size",
    title: "Orientation bound by size",
    shortTitle: "Body size",
    unit: "deg",
    x: { name: "size", unit: "m", values: sizes, scale: "log", now: size },
    lines,
    bands: [],
    threshold: null,
    scale: "log",
    note: size > 0 ? sentence(sizes, curves[form]) : "A single sensor has no size.",
  };
}

/** How the bound falls while bodies are small, and from which size on one degree is reached. */
export function sentence(sizes: Float64Array, bounds: Float64Array): string {
  const slope = Math.log(bounds[1] / bounds[0]) / Math.log(sizes[1] / sizes[0]);
  if (!Number.isFinite(slope)) return "No size lets these sensors see every rotation.";
  const inverse = Math.abs(slope + 1) < SLOPE_TOLERANCE ? " (∝\u00a01/size)" : "";
  const needed = sizeFor(1, sizes, bounds);
  const reached =
    needed === null ? "1 deg is not reached" : `1\u00a0deg from ${formatReading(needed)}\u00a0m`;
  return `Small bodies: slope ${formatNumber(Number(slope.toFixed(2)))}${inverse}. ${reached}.`;
}

/** The least size at which the bound is no larger than `wanted`, between the points on a straight line of logarithms. */
export function sizeFor(wanted: number, sizes: Float64Array, bounds: Float64Array): number | null {
  const there = bounds.findIndex((bound) => bound <= wanted);
  if (there < 0) return null;
  if (there === 0) return sizes[0];
  const share = Math.log(bounds[there - 1] / wanted) / Math.log(bounds[there - 1] / bounds[there]);
  return sizes[there - 1] * (sizes[there] / sizes[there - 1]) ** share;
}
