/** Claims in words: numbers as the command line prints them. */
import { formatNumber } from "../controls/format";
import type { Estimate } from "../generated/Estimate";
import type { Interval } from "../generated/Interval";
import type { Verdict } from "../generated/Verdict";

export const VERDICTS: Record<Verdict, { readonly symbol: string; readonly words: string }> = {
  holds: { symbol: "✓", words: "holds" },
  "does-not-hold": { symbol: "✗", words: "does not hold" },
  "not-decided": { symbol: "?", words: "not decided" },
};

/** Digits of a standard error; a number is not known better than that. */
const ERROR_DIGITS = 2;
const EXACT_DIGITS = 4;
/** Most digits after the point; beyond, an exponent is easier to read. */
const MOST_DECIMALS = 7;

/** The error with two digits; the value alone where the error does not reach its first four. */
export function foundWords(found: Estimate | null): string {
  if (found === null || !Number.isFinite(found.value)) return "no number";
  return withError(found).replaceAll("e+", "e").replaceAll("-", "\u2212");
}

function withError({ value, standard_error: error }: Estimate): string {
  const first = Math.abs(value) < 1e6 ? decimals(value, EXACT_DIGITS) : null;
  const both = decimals(error, ERROR_DIGITS);
  if (value === 0 && error === 0) return "0";
  if (first !== null && Number(error.toFixed(first)) === 0) return value.toFixed(first);
  if (first !== null && both !== null) return `${value.toFixed(both)} ± ${error.toFixed(both)}`;
  if (error < 5e-4 * Math.abs(value)) return value.toExponential(3);
  return `${value.toExponential(2)} ± ${error.toExponential(0)}`;
}

/** How many digits after the point show `digits` digits of a number; null if that is too many. */
function decimals(value: number, digits: number): number | null {
  const exponent = Number(value.toExponential(digits - 1).split("e")[1]);
  const count = Math.max(0, digits - 1 - exponent);
  return count <= MOST_DECIMALS ? count : null;
}

export function targetWords({ least, most }: Interval): string {
  if (least !== null && most !== null) return `${formatNumber(least)} to ${formatNumber(most)}`;
  if (least !== null) return `at least ${formatNumber(least)}`;
  return most === null ? "anything" : `at most ${formatNumber(most)}`;
}
