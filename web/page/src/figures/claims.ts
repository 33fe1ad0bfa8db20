/** Claims in words: numbers as the command line prints them. */
import { formatNumber } from "../controls/format";
import type { Claim } from "../generated/Claim";
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

/**
 * The error with two digits; the value alone where the error does not reach its first four, unless these would speak
 * against the verdict.
 */
export function foundWords({ found, target, verdict }: Pick<Claim, "found" | "target" | "verdict">): string {
  if (found === null || !Number.isFinite(found.value)) return "no number";
  const words = withError(found);
  const misleads = !words.includes("±") && alone(Number(words), target) !== verdict;
  return (misleads ? inFull(found) : words).replaceAll("e+", "e").replaceAll("-", "\u2212");
}

function alone(value: number, { least, most }: Interval): Verdict {
  return value >= (least ?? -Infinity) && value <= (most ?? Infinity) ? "holds" : "does-not-hold";
}

function withError({ value, standard_error: error }: Estimate): string {
  const first = Math.abs(value) < 1e6 ? decimals(value, EXACT_DIGITS) : null;
  if (value === 0 && error === 0) return "0";
  if (first !== null && Number(error.toFixed(first)) === 0) return value.toFixed(first);
  if (first !== null && decimals(error, ERROR_DIGITS) !== null)
    return inFull({ value, standard_error: error });
  if (error < 5e-4 * Math.abs(value)) return value.toExponential(3);
  return `${value.toExponential(2)} ± ${error.toExponential(0)}`;
}

/** However small the error is; all digits where it is 0. */
function inFull({ value, standard_error: error }: Estimate): string {
  if (error === 0) return String(value);
  const digits = decimals(error, ERROR_DIGITS);
  return digits === null
    ? `${value} ± ${error.toExponential(0)}`
    : `${value.toFixed(digits)} ± ${error.toFixed(digits)}`;
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
