import { formatNumber, parseNumber } from "./format";

export type Entry = { value: number; wrong: null } | { value: null; wrong: string };

/** What was typed as a number between the limits, or why it is none. */
export function judge(typed: string, min: number, max: number, unit: string): Entry {
  const value = parseNumber(typed);
  if (typed.trim() === "") return { value: null, wrong: "Nothing is typed." };
  if (value === null) return { value: null, wrong: `“${shortened(typed)}” is not a number.` };
  if (value < min || value > max) return { value: null, wrong: `${limits(min, max, unit)}.` };
  return { value, wrong: null };
}

/** The step that is set; without one a unit of the value's second digit, so that it fits at every size. */
export function stepOf(value: number, step: number | undefined): number {
  if (step !== undefined) return step;
  return value === 0 ? 0.01 : 10 ** (Math.floor(Math.log10(Math.abs(value))) - 1);
}

/** The sum within the limits, without the digits that binary fractions leave. */
export function stepped(value: number, delta: number, min: number, max: number): number {
  return Math.min(max, Math.max(min, Number((value + delta).toPrecision(12)) + 0));
}

function limits(min: number, max: number, unit: string): string {
  const most = `${formatNumber(max)} ${unit}`.trim();
  const least = `${formatNumber(min)} ${unit}`.trim();
  if (max === Infinity) return `At least ${least}`;
  if (min === -Infinity) return `At most ${most}`;
  return `From ${least} to ${most}`;
}

function shortened(typed: string): string {
  const text = typed.trim();
  return text.length > 20 ? `${text.slice(0, 19)}…` : text;
}
