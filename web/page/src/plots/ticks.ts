import type { ScaleKind } from "./spec";

/** The round numbers of an axis: at most `most` of them, the same on the screen and in exported pictures. */
export function ticks(range: readonly [number, number], scale: ScaleKind, most: number): number[] {
  return scale === "log" ? logTicks(range, most) : linearTicks(range, most);
}

/** Equal steps of 1, 2 or 5 times a power of ten. */
export function linearTicks([low, high]: readonly [number, number], most: number): number[] {
  const rough = (high - low) / Math.max(1, most);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5].find((digit) => digit * power >= rough * (1 - 1e-9)) ?? 10);
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: count }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** All digits times powers of ten where they fit, else 1, 2, 5, else 1, 3, else powers of ten or some of them. */
function logTicks([low, high]: readonly [number, number], most: number): number[] {
  const [first, last] = [Math.floor(Math.log10(low) + 1e-9), Math.ceil(Math.log10(high) - 1e-9)];
  const inside = (value: number) => value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9);
  const candidates = [[1, 2, 3, 4, 5, 6, 7, 8, 9], [1, 2, 5], [1, 3], [1]].map((digits) =>
    powers(first, last, 1).flatMap((power) => digits.map((digit) => digit * 10 ** power)),
  );
  const sparse = [2, 3, 5, 10].map((stride) => powers(first, last, stride).map((power) => 10 ** power));
  const lists = [...candidates, ...sparse].map((list) => list.filter(inside));
  const chosen = lists.find((list) => list.length <= most) ?? lists[lists.length - 1];
  const list = chosen.length > 1 ? chosen : [low, high];
  return list.map((value) => Number(value.toPrecision(2)));
}

function powers(first: number, last: number, stride: number): number[] {
  const list = [];
  for (let power = first; power <= last; power++) if (power % stride === 0) list.push(power);
  return list;
}

export function tickLabel(value: number): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e-3 && size < 1e5 ? String(Number(value.toPrecision(6))) : value.toExponential(0);
}
