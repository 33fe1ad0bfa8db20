/** Where a value stands on a slider, and back. */
export interface SliderScale {
  readonly min: number;
  readonly max: number;
  /** Equal ways on the slider are equal factors instead of equal differences. */
  readonly log?: boolean;
  /** The left end is 0, which no factor reaches. */
  readonly zero?: boolean;
}

export const STOPS = 400;

export function stopOf(value: number, { min, max, log = false, zero = false }: SliderScale): number {
  if (zero && value <= 0) return 0;
  const clamped = Math.min(max, Math.max(min, value));
  const share = log ? Math.log(clamped / min) / Math.log(max / min) : (clamped - min) / (max - min);
  return Math.max(zero ? 1 : 0, Math.round(share * STOPS));
}

/** The value at a stop, with as many digits as a hand can set. */
export function valueOf(stop: number, { min, max, log = false, zero = false }: SliderScale): number {
  if (zero && stop === 0) return 0;
  const share = stop / STOPS;
  const exact = log ? min * (max / min) ** share : min + share * (max - min);
  return Number(exact.toPrecision(3));
}
