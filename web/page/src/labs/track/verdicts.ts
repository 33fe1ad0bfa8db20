import { formatReading } from "../../controls/format";
import type { Curve, EstimatorCurves, StudyCurves } from "../../study";
import { joined } from "../../words";
import { meanBand } from "../../plots/consistency-bands";
import { settledNis } from "./plots";

/** How likely a picture of consistent filters is to say anything. */
const WRONGLY = 0.002;

/** One statistic of one estimator: its means over their degrees of freedom, which the steps need not share. */
interface Means {
  readonly label: string;
  readonly mean: Curve;
  readonly degrees: (step: number) => number;
  readonly failures: Uint32Array;
}

/** Whether the filters keep what they claim, in a sentence or two. */
export function verdict({ estimators, trials }: StudyCurves): string {
  const found = [neesVerdict(estimators, trials), nisVerdict(estimators, trials)].filter(
    (text) => text !== null,
  );
  return found.join(" ") || "NEES and NIS stay within what chance allows.";
}

export function neesVerdict(estimators: readonly EstimatorCurves[], trials: number): string | null {
  const means = estimators.map(({ label, nees, neesDegreesOfFreedom, failures }) => ({
    label,
    mean: nees,
    degrees: () => neesDegreesOfFreedom,
    failures,
  }));
  return outside("NEES", means, trials);
}

export function nisVerdict(estimators: readonly EstimatorCurves[], trials: number): string | null {
  const means = estimators.map(({ label, nis, nisDegreesOfFreedom, failures }) => ({
    label,
    mean: { ...nis, value: settledNis(nis.value) },
    degrees: (step: number) => nisDegreesOfFreedom[step],
    failures,
  }));
  return outside("NIS", means, trials);
}

/** Who claims too small errors, or else too large ones: farther off than chance takes a mean over so many trials. */
function outside(name: string, all: readonly Means[], trials: number): string | null {
  const steps = all[0]?.mean.value.length ?? 0;
  const probability = 1 - WRONGLY / Math.max(1, all.length * steps);
  const found = all.flatMap((means) => worst(means, trials, probability));
  const sure = found.filter((excess) => excess.above);
  if (sure.length > 0) {
    const most = sure.reduce((one, other) => (other.value > one.value ? other : one));
    return `${named(sure, all, "is too sure of itself", "are too sure of themselves")}: mean ${name} up to ${formatReading(most.value)} (by chance ${formatReading(most.edge)}).`;
  }
  if (found.length === 0) return null;
  const least = found.reduce((one, other) => (other.value < one.value ? other : one));
  return `${named(found, all, "knows more than it claims", "know more than they claim")}: mean ${name} down to ${formatReading(least.value)} (by chance ${formatReading(least.edge)}).`;
}

interface Excess {
  readonly label: string;
  readonly above: boolean;
  readonly value: number;
  /** The end of the band there. */
  readonly edge: number;
}

/** The step at which the means are farthest above the band; where none is, farthest below it. */
function worst({ label, mean, degrees, failures }: Means, trials: number, probability: number): Excess[] {
  const found = Array.from(mean.value, (value, step): Excess | null => {
    const counted = trials - failures[step];
    if (!Number.isFinite(value) || counted <= 0 || !(degrees(step) > 0)) return null;
    const [low, high] = meanBand(degrees(step), counted, probability);
    if (value >= low && value <= high) return null;
    return { label, value, above: value > high, edge: value > high ? high : low };
  }).filter((excess) => excess !== null);
  const sorted = found.toSorted((one, other) => other.value - one.value);
  const [first, last] = [sorted[0], sorted[sorted.length - 1]];
  return first === undefined ? [] : [first.above ? first : last];
}

function named(found: readonly Excess[], all: readonly Means[], one: string, many: string): string {
  if (found.length === 1) return `${found[0].label} ${one}`;
  return `${found.length === all.length && all.length > 2 ? "All filters" : joined(found)} ${many}`;
}
