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

/** Two digits of the standard error, and the number to the same place. */
export function foundWords(found: Estimate | null): string {
  if (found === null || !Number.isFinite(found.value)) return "no number";
  const { value, standard_error: error } = found;
  if (!(error > 0)) return formatNumber(value, 4);
  const places = Math.min(12, Math.max(0, 1 - Math.floor(Math.log10(error))));
  return `${value.toFixed(places)} ± ${error.toFixed(places)}`.replaceAll("-", "\u2212");
}

export function targetWords({ least, most }: Interval): string {
  if (least !== null && most !== null) return `${formatNumber(least)} to ${formatNumber(most)}`;
  if (least !== null) return `at least ${formatNumber(least)}`;
  return most === null ? "anything" : `at most ${formatNumber(most)}`;
}
