/** First digits of levels, from few to many in a power of ten. */
const DIGITS = [
  [1, 2, 5],
  [1, 1.5, 2, 3, 4, 5, 7],
  [1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3, 3.5, 4, 4.5, 5, 6, 7, 8, 9],
  Array.from({ length: 90 }, (_, i) => (10 + i) / 10),
];
/** With fewer levels one does not see which way the numbers grow. */
const LEAST = 4;

/**
 * Round numbers from `low` to `high`: 1, 2 and 5 times the powers of ten. Between ends that hold few of these there are
 * finer ones; where `most` would not hold all, only powers of ten, or each n-th.
 */
export function logLevels(low: number, high: number, most: number): number[] {
  const [first, last] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))];
  const powers = Array.from({ length: last - first + 1 }, (_, i) => first + i);
  // Ends that are levels themselves stay in whatever the last bit of a factor did to them.
  const within = (value: number) => value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9);
  const levels = (digits: readonly number[]) =>
    powers.flatMap((power) => digits.map((digit) => Number(`${digit}e${power}`))).filter(within);
  const fitting = DIGITS.map(levels).filter(({ length }) => length <= most);
  if (fitting.length > 0) return fitting.find(({ length }) => length >= LEAST) ?? fitting.at(-1)!;
  const tens = levels([1]);
  const step = Math.ceil(tens.length / most);
  return tens.filter((_, i) => i % step === 0);
}
