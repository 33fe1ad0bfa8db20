import type { PlotAxis } from "./spec";

/** More points than this on a line cannot be told apart and slow the drawing down. */
export const MOST_POINTS = 500;

/** How many steps share two drawn points: 1 means that every step is drawn. */
export function stepsPerBucket(steps: number, most = MOST_POINTS): number {
  return steps <= most ? 1 : Math.ceil((2 * steps) / most);
}

/** The steps at whose times the points are drawn: all of them, or two a bucket. */
export function drawnSteps(steps: number, size: number): number[] {
  if (size === 1) return Array.from({ length: steps }, (_, step) => step);
  const list = [];
  for (let start = 0; start < steps; start += size)
    list.push(start, Math.min(steps - 1, start + (size >> 1)));
  return list;
}

/** The least and the largest value of each bucket, the earlier one first: no peak and no dip is lost. */
export function thin(values: Float64Array, size: number): (number | null)[] {
  if (size === 1) return Array.from(values, (value) => (Number.isNaN(value) ? null : value));
  const list: (number | null)[] = [];
  for (let start = 0; start < values.length; start += size)
    list.push(...extremes(values, start, Math.min(values.length, start + size)));
  return list;
}

function extremes(values: Float64Array, start: number, end: number): [number | null, number | null] {
  let [least, largest] = [-1, -1];
  for (let step = start; step < end; step++) {
    if (Number.isNaN(values[step])) continue;
    if (least < 0 || values[step] < values[least]) least = step;
    if (largest < 0 || values[step] > values[largest]) largest = step;
  }
  if (least < 0) return [null, null];
  return least < largest ? [values[least], values[largest]] : [values[largest], values[least]];
}

/** The step that lies nearest to a place on the axis, as the eye sees it. */
export function nearestStep({ values, scale }: Pick<PlotAxis, "values" | "scale">, place: number): number {
  let [low, high] = [0, values.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] <= place) low = middle;
    else high = middle;
  }
  const seen = (value: number) => (scale === "log" ? Math.log(value) : value);
  return seen(place) - seen(values[low]) <= seen(values[high]) - seen(place) ? low : high;
}
