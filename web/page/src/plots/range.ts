import { type PlotLine, type PlotSpec, type ScaleKind, SPREAD } from "./spec";
import { linearTicks } from "./ticks";

export type Range = readonly [number, number];

/** What the value axis has to hold. */
type Values = Pick<PlotSpec, "x" | "lines" | "bands" | "threshold" | "ceiling">;

/** Along time errors dip towards zero where they change sign; what lies further below the largest value is cut off. */
const MOST_DECADES = 3;

/** Ends of the value axis on round numbers that hold the data, so that small changes do not move it. */
export function valueRange(spec: Values, scale: ScaleKind): Range {
  return scale === "log" ? logRange(spec) : linearRange(spec);
}

function logRange(spec: Values): Range {
  const [low, high] = extent(spec, (value) => value > 0);
  if (high === -Infinity) return [0.1, 1];
  const cut = spec.x.timed ? Math.max(low, high / 10 ** MOST_DECADES) : low;
  const [bottom, top] = [roundDown(cut), roundUp(high)];
  return top > bottom ? [bottom, top] : [bottom / 2, top * 2];
}

/** Errors, shares and ratios start at zero. */
function linearRange(spec: Values): Range {
  const [, most] = extent(spec, (value) => value >= 0);
  const high = Math.min(most, spec.ceiling ?? Infinity);
  if (!(high > 0)) return [0, 1];
  const ticks = linearTicks([0, high], 5);
  const step = ticks[1] - ticks[0];
  return [0, Number((step * Math.ceil(high / step - 1e-9)).toPrecision(12))];
}

function extent({ lines, bands, threshold }: Values, wanted: (value: number) => boolean): Range {
  let [low, high] = [Infinity, -Infinity];
  const take = (value: number) => {
    if (!wanted(value) || !Number.isFinite(value)) return;
    low = Math.min(low, value);
    high = Math.max(high, value);
  };
  for (const line of lines) takeLine(line, take);
  for (const band of bands) [band.low, band.high].forEach(take);
  threshold?.heights.forEach(take);
  return [low, high];
}

function takeLine({ values, standardErrors }: PlotLine, take: (value: number) => void): void {
  values.forEach(take);
  standardErrors?.forEach((error, step) => take(values[step] + SPREAD * error));
}

function roundDown(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const digit = value / power;
  return Number(((digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power).toPrecision(1));
}

function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const digit = value / power;
  return Number(((digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10) * power).toPrecision(1));
}
