import type { PlotSpec } from "./spec";

/** Errors dip towards zero where they change sign; what lies further below the largest value is cut off. */
const MOST_DECADES = 3;

/** Ends of a logarithmic axis on 1, 2, 5 times powers of ten, so that small changes do not move it. */
export function logRange(spec: Pick<PlotSpec, "lines" | "threshold">): [number, number] {
  let low = Infinity;
  let high = 0;
  const take = (value: number | null) => {
    if (value === null || !(value > 0) || !Number.isFinite(value)) return;
    low = Math.min(low, value);
    high = Math.max(high, value);
  };
  for (const line of spec.lines) line.values.forEach(take);
  if (spec.threshold) take(spec.threshold.value);
  if (high === 0) return [0.1, 1];
  const cut = Math.max(low, high / 10 ** MOST_DECADES);
  const [bottom, top] = [roundDown(cut), roundUp(high)];
  return top > bottom ? [bottom, top] : [bottom / 2, top * 2];
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
