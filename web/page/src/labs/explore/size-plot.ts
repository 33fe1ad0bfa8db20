import { DEGREES_PER_RADIAN, formatNumber, formatReading } from "../../controls/format";
import { sizeCurve } from "../../engine";
import type { RangeForm } from "../../generated/RangeForm";
import type { PlotLine, PlotSpec } from "../../plots/spec";
import { sizeOf } from "../../rigid-body/topologies";
import type { Scenario } from "../../scenario";

/** The bound on the orientation against the size of the body: how large it must be. */

const FORMS: readonly { form: RangeForm; dash: readonly number[] }[] = [
  { form: "projected", dash: [7, 4] },
  { form: "raw", dash: [10, 3, 2, 3] },
];
/** From a thousandth of the scene to all of it. */
const DECADES = 3;
const POINTS_PER_DECADE = 12;
/** With more ranges than this a point takes so long that a drag would stutter: then there are fewer of them. */
const MANY_RANGES = 2000;
const FEWER_PER_DECADE = 3;
/** Slopes nearer than this to -1 are that of small bodies. */
const SLOPE_TOLERANCE = 0.02;

export function sizePlot(scenario: Scenario): PlotSpec {
  const size = sizeOf(scenario.sensors);
  const many = scenario.anchors.length * scenario.sensors.length > MANY_RANGES;
  const perDecade = many ? FEWER_PER_DECADE : POINTS_PER_DECADE;
  const sizes = sizesAround(size, extentOf(scenario.anchors), perDecade);
  const bound = (form: RangeForm) =>
    boundInDegrees({ ...scenario, field: { ...scenario.field, form } }, sizes);
  const lines = FORMS.map(({ form, dash }): PlotLine => {
    const label = `${form} ranges`;
    const values = size > 0 ? bound(form) : new Float64Array(sizes.length).fill(NaN);
    return { name: form, label, token: "bound", mark: null, dash, values, standardErrors: null, events: [] };
  });
  const used = lines.find(({ name }) => name === scenario.field.form) ?? lines[0];
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
    note: size > 0 ? sentence(sizes, used.values) : "A single sensor has no size.",
  };
}

/** Even steps on a logarithmic scale that hold the size itself, over whole decades of the scene. */
export function sizesAround(size: number, extent: number, perDecade: number): Float64Array {
  const top = Math.ceil(Math.log10(extent) - 1e-9);
  const own = size > 0 ? Math.log10(size) : top;
  const [low, high] = [Math.min(top - DECADES, Math.floor(own)), Math.max(top, Math.ceil(own))];
  const count = (high - low) * perDecade;
  const steps = Array.from({ length: count + 1 }, (_, k) => 10 ** (low + k / perDecade));
  const others = steps.filter((step) => Math.abs(Math.log(step / size)) > 1e-6);
  return Float64Array.from(size > 0 ? [...others, size] : steps).sort();
}

function extentOf(anchors: Scenario["anchors"]): number {
  const sides = anchors[0].map((_, axis) => {
    const values = anchors.map((anchor) => anchor[axis]);
    return Math.max(...values) - Math.min(...values);
  });
  return Math.max(...sides) || 1;
}

function boundInDegrees(scenario: Scenario, sizes: Float64Array): Float64Array {
  const size = sizeOf(scenario.sensors);
  const scales = sizes.map((value) => value / size);
  return sizeCurve(scenario, scales).map((bound) => bound * DEGREES_PER_RADIAN);
}

/** How the bound falls while bodies are small, and from which size on one degree is reached. */
export function sentence(sizes: Float64Array, bounds: Float64Array): string {
  const slope = Math.log(bounds[1] / bounds[0]) / Math.log(sizes[1] / sizes[0]);
  if (!Number.isFinite(slope)) return "No size lets these sensors see every rotation.";
  const halves = Math.abs(slope + 1) < SLOPE_TOLERANCE ? " (size\u00a0×\u00a02, bound\u00a0÷\u00a02)" : "";
  const needed = sizeFor(1, sizes, bounds);
  const reached =
    needed === null ? "1 deg is not reached" : `1\u00a0deg from ${formatReading(needed)}\u00a0m`;
  return `Small bodies: slope ${formatNumber(Number(slope.toFixed(2)))}${halves}. ${reached}.`;
}

/** The least size at which the bound is no larger than `wanted`, between the points on a straight line of logarithms. */
export function sizeFor(wanted: number, sizes: Float64Array, bounds: Float64Array): number | null {
  const there = bounds.findIndex((bound) => bound <= wanted);
  if (there < 0) return null;
  if (there === 0) return sizes[0];
  const share = Math.log(bounds[there - 1] / wanted) / Math.log(bounds[there - 1] / bounds[there]);
  return sizes[there - 1] * (sizes[there] / sizes[there - 1]) ** share;
}
