import type { LabRun } from "../lab";
import { pointAt } from "../run";
import type { RangeNoise } from "../scenario";

/** What a noise level means in metres, whatever its model: the models name it differently. */

/** More steps than this tell nothing new about how far away the anchors are. */
const MOST_STEPS = 50;

/** Median over time and anchors of the distance between body and anchor, m. */
export function medianRange(run: LabRun): number {
  const stride = Math.max(1, Math.floor(run.steps / MOST_STEPS));
  const ranges: number[] = [];
  for (let step = 0; step < run.steps; step += stride) {
    const body = pointAt(run.truth.positions, step, run.dimension);
    for (const anchor of run.anchors)
      ranges.push(Math.hypot(...anchor.map((coordinate, axis) => coordinate - body[axis])));
  }
  ranges.sort((a, b) => a - b);
  const middle = ranges.length >> 1;
  return ranges.length % 2 === 1 ? ranges[middle] : (ranges[middle - 1] + ranges[middle]) / 2;
}

/** Standard deviation of one range at a distance, m: to first order `var(d) = 4 r^2 var(r)` for the squared range `d`. */
export function rangeDeviation(noise: RangeNoise, range: number): number {
  if (noise.kind === "range") return noise.sigma;
  if (noise.kind === "squared_range") return noise.sigma / 2;
  return range * 10 ** (-noise.zeta_db / 20);
}

/** The noise of another model that disturbs a range at this distance as much. */
export function sameNoiseAs(noise: RangeNoise, kind: RangeNoise["kind"], range: number): RangeNoise {
  const deviation = rangeDeviation(noise, range);
  const rounded = (value: number) => Number(value.toPrecision(3));
  if (kind === "range") return { kind, sigma: rounded(deviation) };
  if (kind === "squared_range") return { kind, sigma: rounded(2 * deviation) };
  return { kind, zeta_db: rounded(20 * Math.log10(range / deviation)) };
}

/** How far the noise lies below a range, dB: zeta of the time-of-arrival model, and of the others at that range. */
export function levelBelow(noise: RangeNoise, range: number): number {
  return noise.kind === "toa" ? noise.zeta_db : 20 * Math.log10(range / rangeDeviation(noise, range));
}

/** The noise of a model that lies so many decibels below a range. */
export function noiseBelow(kind: RangeNoise["kind"], range: number, level: number): RangeNoise {
  const deviation = range * 10 ** (-level / 20);
  if (kind === "toa") return { kind, zeta_db: level };
  return { kind, sigma: kind === "range" ? deviation : 2 * deviation };
}
