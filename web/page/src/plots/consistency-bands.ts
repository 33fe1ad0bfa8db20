import { chiSquaredInterval } from "../engine";
import type { Band } from "./spec";

/** Where the mean of χ² over its degrees of freedom lies with so much probability: trials add up their degrees. */
export function meanBand(degrees: number, trials: number, probability: number): [number, number] {
  const freedom = degrees * trials;
  const [low, high] = chiSquaredInterval(freedom, probability);
  return [low / freedom, high / freedom];
}

/** Where 95 % of the means over so many trials lie if the covariances are right, once for each number of degrees. */
export function neesBands(
  estimators: readonly { readonly neesDegreesOfFreedom: number }[],
  trials: number,
): Band[] {
  return bandsOf(
    estimators.map((estimator) => estimator.neesDegreesOfFreedom),
    trials,
  );
}

/** The same for innovations. Missing ranges lower the degrees: the band is that of the steps that miss none. */
export function nisBands(
  estimators: readonly { readonly nisDegreesOfFreedom: ArrayLike<number> }[],
  trials: number,
): Band[] {
  const most = ({ nisDegreesOfFreedom }: (typeof estimators)[number]) =>
    Math.max(0, ...Array.from(nisDegreesOfFreedom));
  return bandsOf(estimators.map(most), trials);
}

function bandsOf(degrees: readonly number[], trials: number): Band[] {
  return [...new Set(degrees)]
    .filter((each) => each > 0)
    .toSorted((a, b) => a - b)
    .map((each) => {
      const [low, high] = meanBand(each, trials, 0.95);
      return { low, high, label: `95 % of χ² with ${Number(each.toFixed(1))} degrees of freedom` };
    });
}
