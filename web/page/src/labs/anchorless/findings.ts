import { formatReading } from "../../controls/format";
import type { KinematicsBounds } from "../../engine";
import { type Finding, weightiest } from "../../findings";
import { asSentence, countOf, startOf } from "../../words";
import { estimatorOf } from "./estimators";
import { type Level, levelsOfReport, levelsOfRun, overBound } from "./levels";
import type { AnchorlessRun } from "./run";
import type { StampAverages } from "./study";
import type { SweepAverages } from "./sweep";

/** An average this near its bound is at it. */
const AT_BOUND = 1.15;
/** So many times better is worth a sentence. */
const TELLING = 1.15;
/** An error that shrinks this many times when it is aligned anew was a turn of the whole network. */
const A_TURN = 3;
const [VELOCITY, ACCELERATION] = [1, 2];
/** Errors of one trial differ by chance, but not this much. */
const BEYOND_CHANCE = 5;

/** What one trial shows, in up to three sentences: what is no matter of chance. */
export function describe(run: AnchorlessRun): string {
  if (run.trial.estimators.length === 0) return "No estimator is switched on.";
  const levels = levelsOfRun(run);
  const found = [failing(run), drowning(run), farthest(levels), turning(levels), bought(run.bounds, levels)];
  return weightiest(found.filter((finding) => finding !== null));
}

/** What the averages show, and how sure they are. */
export function studyVerdict(averages: StampAverages): string {
  const levels = levelsOfReport(averages, averages.bounds);
  return verdict(levels, averages.bounds, averages.trials, `${averages.stamps} stamps`);
}

/** What the sweep shows, at the number of stamps in its middle. */
export function sweepVerdict({ reports, bounds, trials }: SweepAverages): string {
  const middle = reports.length >> 1;
  const levels = levelsOfReport(reports[middle], bounds[middle]);
  return verdict(levels, bounds[middle], trials, `K = ${reports[middle].stamps}`);
}

function verdict(levels: readonly Level[], bounds: KinematicsBounds, trials: number, where: string): string {
  if (levels.length === 0) return "No estimator that finds a motion is switched on.";
  const found = [
    paperBeaten(levels),
    nearest(levels, startOf(`${where}, ${trials} trials`)),
    turning(levels),
    bought(bounds, levels),
  ];
  return weightiest(found.filter((finding) => finding !== null));
}

/** The first estimator that gave nothing, and why: the others go on. */
function failing({ trial }: AnchorlessRun): Finding | null {
  const failed = trial.estimators.filter(({ failure }) => failure !== null);
  const [first] = failed;
  if (!first?.failure) return null;
  const more = failed.length > 1 ? ` (and ${countOf(failed.length - 1)} more)` : "";
  const text = `${estimatorOf(first.name).label}${more} gives nothing: ${asSentence(first.failure)}`;
  return { weight: 100, text };
}

/** Algorithm 1 reads accelerations from the last coefficient of the Gram matrix, which may be noise. */
function drowning({ trial }: AnchorlessRun): Finding | null {
  const one = trial.estimators.find(
    ({ acceleration_margin }) => acceleration_margin !== null && acceleration_margin < 1,
  );
  if (!one) return null;
  const { label } = estimatorOf(one.name);
  return {
    weight: 80,
    text: `${label}: the accelerations drown, their least eigenvalue is ${formatReading(one.acceleration_margin)} times that of noise.`,
  };
}

const best = (levels: readonly Level[]) =>
  levels.reduce<Level | null>(
    (one, other) => (one && one.errors[VELOCITY] <= other.errors[VELOCITY] ? one : other),
    null,
  );

/** The paper's claim that accelerometers are needed, against distances used well. */
function paperBeaten(levels: readonly Level[]): Finding | null {
  const distances = best(levels.filter(({ senses, errors }) => !senses && errors.length > VELOCITY));
  const second = best(
    levels.filter(({ name, errors }) => name.startsWith("algorithm-2") && errors.length > VELOCITY),
  );
  if (!distances || !second) return null;
  const ratio = second.errors[VELOCITY] / distances.errors[VELOCITY];
  const [one, other] = [distances.label, second.label];
  const far = formatReading(Math.max(ratio, 1 / ratio));
  if (ratio > TELLING)
    return {
      weight: 70,
      text: `Without accelerometers ${one} finds velocities ${far} times better than ${other} with them.`,
    };
  if (1 / ratio > TELLING)
    return {
      weight: 60,
      text: `${other} finds velocities ${far} times better than the best from distances, ${one}.`,
    };
  return null;
}

/** The estimator nearest to its own bound in the velocities, and the farthest one. */
function nearest(levels: readonly Level[], where: string): Finding | null {
  const rated = levels
    .map((level) => ({ level, ratio: overBound(level, VELOCITY) }))
    .filter((entry): entry is { level: Level; ratio: number } => entry.ratio !== null)
    .toSorted((one, other) => one.ratio - other.ratio);
  const [first, last] = [rated[0], rated.at(-1)];
  if (!first || !last) return null;
  const near =
    first.ratio < AT_BOUND
      ? `${first.level.label} is at its bound in velocity (${times(first)})`
      : `${first.level.label} is ${times(first)} its bound in velocity`;
  if (first === last) return { weight: 65, text: `${where}: ${near}.` };
  return { weight: 65, text: `${where}: ${near}, ${last.level.label} ${times(last)}.` };
}

function times({ level, ratio }: { level: Level; ratio: number }): string {
  const error = level.standardErrors?.[VELOCITY];
  const spread = error === undefined ? "" : ` ± ${formatReading((error * ratio) / level.errors[VELOCITY])}`;
  return `${formatReading(ratio)}${spread} ×`;
}

/** The largest difference between two estimators in one trial, where it is larger than chance makes it. */
function farthest(levels: readonly Level[]): Finding | null {
  const [velocity, acceleration] = [VELOCITY, ACCELERATION].map((l) => {
    const errors = levels
      .filter((level) => level.errors[l] > 0)
      .toSorted((a, b) => a.errors[l] - b.errors[l]);
    const [best, worst] = [errors[0], errors.at(-1)];
    return best && worst ? { best, worst, ratio: worst.errors[l] / best.errors[l], l } : null;
  });
  const all = [velocity, acceleration].filter((entry) => entry !== null && entry.ratio > BEYOND_CHANCE);
  const [most] = all.toSorted((a, b) => b!.ratio - a!.ratio);
  if (!most) return null;
  const what = most.l === VELOCITY ? "velocity" : "acceleration";
  const factor = formatReading(most.ratio);
  return {
    weight: 60,
    text: `${most.worst.label} errs ${factor} times as much in ${what} as ${most.best.label}.`,
  };
}

/** What grows away from time 0 is one turn of the whole network, where aligning anew takes it away. */
function turning(levels: readonly Level[]): Finding | null {
  const turned = levels.filter(({ last }) => last !== null && last.one > A_TURN * last.aligned);
  const [most] = turned.toSorted((one, other) => share(other) - share(one));
  if (!most?.last) return null;
  const { one, aligned } = most.last;
  return {
    weight: 50,
    text: `At the end ${most.label} is ${formatReading(one)} m off, but ${formatReading(aligned)} m once aligned there: most of it is one turn of all.`,
  };
}

const share = ({ last }: Level) => (last ? last.one / last.aligned : 0);

/** What accelerometers could give at most, by the bounds. */
function bought({ distances, accelerometers }: KinematicsBounds, levels: readonly Level[]): Finding | null {
  if (!levels.some(({ senses }) => senses)) return null;
  const [sensed, without] = [accelerometers.coefficients, distances.coefficients];
  if (!(sensed.length > 2 && without.length > 2)) return null;
  const ratio = (l: number) => formatReading(without[l] / sensed[l]);
  return {
    weight: 40,
    text: `By the bounds accelerometers buy ${ratio(0)} × in position, ${ratio(1)} × in velocity, ${ratio(2)} × in acceleration.`,
  };
}
