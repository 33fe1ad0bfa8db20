import { UNBOUNDED } from "../../scene/field";

/** Ends of a logarithmic scale in the unit of the values: 0 < low < high. */
export interface Ends {
  readonly low: number;
  readonly high: number;
}

/** So many values tell where the ends of the scale are. */
const MOST_VALUES = 4096;
/** The largest values stand beside a body that loses its last range: they would take all of the scale. */
const SHOWN_SHARE = 0.97;
/** The ends differ at least by this factor, or rounding would be coloured. */
const LEAST_RATIO = 1.02;
/** Round ends differ at least by this one. */
const LEAST_ROUND_RATIO = 1.5;
/** Ends stay while the values reach no farther beyond either of them than by this share of the scale as it is drawn, */
const MOST_BEYOND = 0.1;
/** and while they take at least this share of it. */
const LEAST_SHARE = 0.5;

/** The least of the bounds, and the largest but for those few; null where there is none. */
function spanOf(values: Float32Array): Ends | null {
  const stride = Math.ceil(values.length / MOST_VALUES);
  const bounds = values.filter((value, index) => index % stride === 0 && value < UNBOUNDED).sort();
  if (bounds.length === 0) return null;
  return { low: bounds[0], high: bounds[Math.floor(SHOWN_SHARE * (bounds.length - 1))] };
}

/** Round ends of the scale around most of the bounds; `factor` takes the values to the unit that is round. */
export function scaleOf(values: Float32Array, factor: number): Ends {
  const span = spanOf(values);
  if (span === null) return { low: 0.01 / factor, high: 1 / factor };
  const low = roundBelow(Math.max(span.low * factor, 1e-12));
  return {
    low: low / factor,
    high: roundAbove(Math.max(span.high * factor, LEAST_ROUND_RATIO * low)) / factor,
  };
}

/** The ends of a scale that takes all its colours for the numbers there are: one more anchor often changes little. */
export function endsOf(values: Float32Array, factor: number): Ends {
  const span = spanOf(values);
  if (span === null) return { low: 0.01, high: 1 };
  const least = Math.max(span.low * factor, 1e-12);
  const most = Math.max(span.high * factor, LEAST_RATIO * least);
  // The third digit of the larger end, so that numbers beside the scale are short.
  const step = 10 ** (Math.floor(Math.log10(most)) - 2);
  const [low, high] = [Math.floor(least / step), Math.ceil(most / step)];
  return { low: (Math.max(low, 0.1) * step) / factor, high: (high * step) / factor };
}

/** Whether a scale still shows the values well. */
function suits({ low, high }: Ends, values: Float32Array): boolean {
  const span = spanOf(values);
  if (span === null) return true;
  const length = Math.log(high / low);
  const [below, above] = [Math.log(low / span.low), Math.log(span.high / high)];
  return Math.max(below, above) <= MOST_BEYOND * length && length + below + above >= LEAST_SHARE * length;
}

/**
 * A scale that keeps its ends as long as they suit the values, so that colours and numbers do not jump while an anchor is
 * dragged over a round number. Values of another kind get ends of their own.
 */
export class SteadyScale {
  #kind = "";
  #ends: Ends | null = null;

  ends(kind: string, values: Float32Array, fresh: (values: Float32Array) => Ends): Ends {
    const last = kind === this.#kind ? this.#ends : null;
    this.#kind = kind;
    return (this.#ends = last && suits(last, values) ? last : fresh(values));
  }
}

/** First digits of round ends. */
const ROUND = [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];

function roundBelow(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * ROUND.findLast((digit) => digit * power <= value * (1 + 1e-12))!;
}

function roundAbove(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * ROUND.find((digit) => digit * power >= value * (1 - 1e-12))!;
}
