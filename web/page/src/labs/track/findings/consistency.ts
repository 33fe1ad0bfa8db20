import { chiSquaredInterval } from "../../../engine";
import { formatReading } from "../../../controls/format";
import type { EstimatorRun } from "../../../run";
import { joined } from "../../../words";
import type { Finding } from "../../../findings";

/** How likely a consistent filter is to be told wrongly: once in a thousand steps on either side. */
const CONSISTENT = 0.998;

/** Estimators whose errors are larger than their covariance allows. */
export function overconfident(running: EstimatorRun[], step: number): Finding | null {
  const found = running.filter((estimator) => estimator.nees[step] > band(estimator)[1]);
  if (found.length === 0) return null;
  const worst = found.reduce((one, other) => (other.nees[step] > one.nees[step] ? other : one));
  const nees = `${found.length > 1 ? "up to " : ""}${formatReading(worst.nees[step])}`;
  return {
    weight: 70,
    text: `${named(found, running)} ${found.length === 1 ? "is" : "are"} over-confident: NEES ${nees}, where ${formatReading(band(worst)[1])} is rarely passed.`,
  };
}

/** Estimators whose ranges come farther off than they expect; the first ones only test the guess one starts from. */
export function surprised(running: EstimatorRun[], step: number): Finding | null {
  if (step === 0) return null;
  const most = ({ nisDegreesOfFreedom }: EstimatorRun) => bandOf(nisDegreesOfFreedom[step])[1];
  const found = running.filter((estimator) => estimator.nis[step] > most(estimator));
  if (found.length === 0) return null;
  const worst = found.reduce((one, other) => (other.nis[step] > one.nis[step] ? other : one));
  const nis = `${found.length > 1 ? "up to " : ""}${formatReading(worst.nis[step])}`;
  return {
    weight: 35,
    text: `The ranges surprise ${found.length > 2 && found.length === running.length ? "all estimators" : joined(found)}: NIS ${nis}, where ${formatReading(most(worst))} is rarely passed.`,
  };
}

/** Estimators whose errors are smaller than they claim. */
export function cautious(running: EstimatorRun[], step: number): Finding | null {
  const found = running.filter((estimator) => estimator.nees[step] < band(estimator)[0]);
  if (found.length === 0) return null;
  const least = Math.min(...found.map((estimator) => estimator.nees[step]));
  return {
    weight: 15,
    text: `${named(found, running)} ${found.length === 1 ? "knows" : "know"} more than claimed: NEES ${found.length > 1 ? "down to " : ""}${formatReading(least)}.`,
  };
}

/** A long list of names says no more than that it is all of them. */
function named(found: readonly EstimatorRun[], running: readonly EstimatorRun[]): string {
  return found.length > 2 && found.length === running.length ? "All estimators" : joined(found);
}

const bands = new Map<number, readonly [number, number]>();

/** What the NEES of a consistent filter lies between; everything where it has none. */
export function band({ neesDegreesOfFreedom }: EstimatorRun): readonly [number, number] {
  return bandOf(neesDegreesOfFreedom);
}

function bandOf(degrees: number): readonly [number, number] {
  if (degrees === 0) return [0, Infinity];
  const known = bands.get(degrees) ?? chiSquaredInterval(degrees, CONSISTENT);
  bands.set(degrees, known);
  return known;
}
