const MINUS = "\u2212";

/** A number as people write it: whole ones whole, others with a few significant digits, a real minus, no trailing zeros. */
export function formatNumber(value: number, digits = 6): string {
  const shown = Number.isInteger(value) ? value : Number(value.toPrecision(digits));
  return shown.toString().replace("-", MINUS);
}

/** Three significant digits: for numbers that change while one looks. */
export function formatReading(value: number | null): string {
  if (value === null || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size === 0) return "0";
  if (size >= 1e6 || size < 1e-4) return value.toExponential(1).replace("e+", "e").replaceAll("-", MINUS);
  return (size >= 100 ? value.toFixed(0) : value.toPrecision(3)).replace("-", MINUS);
}

/** Two significant digits: for standard errors. */
export function formatError(value: number): string {
  const size = Math.abs(value);
  if (!Number.isFinite(value) || size === 0 || size >= 99.5 || size < 1e-4) return formatReading(value);
  return value.toPrecision(2).replace("-", MINUS);
}

/** What was typed, with either minus and either decimal sign; null where it is no finite number. */
export function parseNumber(text: string): number | null {
  const plain = text.trim().replace(MINUS, "-").replace(",", ".");
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain)) return null;
  const value = Number(plain);
  return Number.isFinite(value) ? value : null;
}

export function formatPoint(point: readonly number[]): string {
  return `(${point.map((value) => formatNumber(value)).join(", ")}) m`;
}

export const DEGREES_PER_RADIAN = 180 / Math.PI;
