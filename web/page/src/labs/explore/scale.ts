import { UNBOUNDED } from "../../scene/field";
import { niceBelow } from "../../scene/geometry";

/** Ends of a logarithmic scale in the unit of the values: 0 < low < high. */
export interface Ends {
  readonly low: number;
  readonly high: number;
}

/** So many values tell where the ends of the scale are. */
const MOST_VALUES = 4096;
/** The largest values stand beside a body that loses its last range: they would take all of the scale. */
const SHOWN_SHARE = 0.97;
/** Ends stay while the values reach no farther beyond them than by this factor, */
const MOST_BEYOND = 1.25;
/** and while they take at least this share of the scale, as it is drawn: of its logarithm. */
const LEAST_SHARE = 0.5;

/** The span of most of the bounds; null where there is none. */
function spanOf(values: Float32Array): Ends | null {
  const stride = Math.ceil(values.length / MOST_VALUES);
  const bounds = values.filter((value, index) => index % stride === 0 && value < UNBOUNDED).sort();
  if (bounds.length === 0) return null;
  return { low: bounds[0], high: bounds[Math.floor(SHOWN_SHARE * (bounds.length - 1))] };
}

/** Round ends of the scale around most of the bounds; `factor` takes the values to the unit that is round. */
export function scaleOf(values: Float32Array, factor: number): Ends {
  return roundEnds(spanOf(values), factor);
}

function roundEnds(span: Ends | null, factor: number): Ends {
  if (span === null) return { low: 0.01 / factor, high: 1 / factor };
  const low = niceBelow(Math.max(span.low * factor, 1e-12));
  return { low: low / factor, high: niceAbove(Math.max(span.high * factor, 2 * low)) / factor };
}

/** Whether a scale still shows the values well: nothing jumps while an anchor is dragged over a round number. */
function suits({ low, high }: Ends, span: Ends | null): boolean {
  if (span === null) return true;
  const inside = span.low * MOST_BEYOND >= low && span.high <= high * MOST_BEYOND;
  return inside && Math.log(span.high / span.low) >= LEAST_SHARE * Math.log(high / low);
}

/** A scale that keeps its ends as long as they suit the values; those of another kind get ends of their own. */
export class SteadyScale {
  #kind = "";
  #ends: Ends | null = null;

  ends(kind: string, values: Float32Array, factor: number): Ends {
    const span = spanOf(values);
    const keep = kind === this.#kind && this.#ends !== null && suits(this.#ends, span);
    this.#kind = kind;
    return (this.#ends = keep ? this.#ends! : roundEnds(span, factor));
  }
}

/** Smallest of 1, 2, 5 times a power of ten that is not below `value`. */
function niceAbove(value: number): number {
  const below = niceBelow(value);
  return below >= value ? below : [2, 2.5, 5].map((factor) => below * factor).find((one) => one >= value)!;
}
