const MINUS = "\u2212";

/** A number as people write it: at most six significant digits, a real minus, no trailing zeros. */
export function formatNumber(value: number): string {
  return Number(value.toPrecision(6)).toString().replace("-", MINUS);
}

/** Two significant digits at least and a fixed width for the usual sizes: for numbers that change while one looks. */
export function formatReading(value: number | null): string {
  if (value === null || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size >= 1e5) return value.toExponential(1).replace("e+", "e");
  if (size >= 100) return value.toFixed(0);
  if (size >= 10) return value.toFixed(1);
  if (size >= 1) return value.toFixed(2);
  if (size >= 1e-3 || size === 0) return value.toFixed(4);
  return value.toExponential(1).replace("-", MINUS);
}

/** What was typed, with either minus and either decimal sign; null where it is no finite number. */
export function parseNumber(text: string): number | null {
  const plain = text.trim().replace(MINUS, "-").replace(",", ".");
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain)) return null;
  const value = Number(plain);
  return Number.isFinite(value) ? value : null;
}

export function formatPoint(point: readonly number[]): string {
  return `(${point.map(formatNumber).join(", ")}) m`;
}

export const DEGREES_PER_RADIAN = 180 / Math.PI;
