/** 1, 2 and 5 times the powers of ten from `low` to `high`; only powers of ten, or each n-th, where `most` would not hold all. */
export function logLevels(low: number, high: number, most: number): number[] {
  const [first, last] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))];
  const powers = Array.from({ length: last - first + 1 }, (_, i) => first + i);
  // Ends that are levels themselves stay in whatever the last bit of a factor did to them.
  const within = (value: number) => value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9);
  const fine = powers
    .flatMap((power) => [1, 2, 5].map((digit) => Number(`${digit}e${power}`)))
    .filter(within);
  if (fine.length <= most) return fine;
  const tens = powers.map((power) => Number(`1e${power}`)).filter(within);
  const step = Math.ceil(tens.length / most);
  return tens.filter((_, i) => i % step === 0);
}
