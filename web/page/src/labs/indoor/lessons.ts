import { DEGREES_PER_RADIAN, formatReading } from "../../controls/format";
import type { Finding } from "../../findings";
import type { Convention } from "../../generated/Convention";
import type { FilterName } from "../../generated/FilterName";
import { countOf } from "../../words";

/** What a filter did over a run, or on the average over many. */
export interface Level {
  readonly name: FilterName;
  readonly label: string;
  /** Root mean square error, m. */
  readonly position: number;
  /** Root mean square angle, rad. */
  readonly angle: number;
  /** The largest singular value of its R at the end. */
  readonly stretch: number;
  /** Mean NEES over its degrees of freedom. */
  readonly nees: number;
}

/** Less than this share is no difference worth a word. */
const TELLING = 0.005;
/** Filters whose errors differ by a smaller share are said to do the same. */
const SAME = 1e-3;
/** More digits than this no error is told with. */
const MOST_DIGITS = 6;
/** So many times better or worse is a matter of the integration, not of chance. */
const FAR = 1.5;
/** So many times worse a filter is lost. */
const LOST = 10;
/** An orientation that is so many times worse is worth a word. */
const WORSE = 1.02;
/** Times the claimed square of the error from which a claim is plainly wrong, and up to which it is plainly right. */
const [WRONG, RIGHT] = [4, 1.5];

const EULER: readonly FilterName[] = ["ekf-rie", "ekf-retraction", "ukf-rie", "ekf", "ekf-full", "ukf"];
const EXACT: readonly FilterName[] = ["mekf", "tight", "lie-kf"];

/** Where the differences come from, in the order in which it is read. */
export function lessons(levels: readonly Level[], convention: Convention): Finding[] {
  if (levels.length === 0) return [{ weight: 100, text: "No filter is switched on." }];
  const found = [
    ...(agreement(levels) ?? [
      growth(levels),
      gain(levels),
      integration(levels, convention),
      orientation(levels),
    ]),
    consistency(levels),
    nearest(levels),
  ];
  return found.filter((finding) => finding !== null);
}

function pick(levels: readonly Level[], names: readonly FilterName[]): Level | undefined {
  return names.flatMap((name) => levels.filter((level) => level.name === name))[0];
}

const apart = (one: number, other: number) => Math.abs(one / other - 1);

/** Where all do the same there is nothing to explain but that. */
function agreement(levels: readonly Level[]): Finding[] | null {
  const [first] = levels;
  const differ = levels.some((level) => apart(level.position, first.position) > TELLING);
  if (differ || levels.length === 1) return null;
  const still = levels.every(({ stretch }) => stretch - 1 < TELLING);
  const why = still ? "hardly anything turns, so R stays a rotation by itself" : "the ranges decide alone";
  return [{ weight: 90, text: `All filters agree to half a per cent: ${why}.` }];
}

/** Euler's rule makes R longer with every turn. */
function growth(levels: readonly Level[]): Finding | null {
  const most = Math.max(...levels.map(({ stretch }) => stretch));
  const grown = levels.find(({ stretch }) => apart(stretch, most) < TELLING);
  if (!grown || most - 1 < TELLING) return null;
  const text = `${grown.label}’s R has grown by ${grown.stretch.toFixed(3)}, and its accelerations R a with it.`;
  return { weight: 85, text };
}

/** What EKFRie gains, and whether retraction alone gains it too. */
function gain(levels: readonly Level[]): Finding | null {
  const [plain, manifold] = [pick(levels, ["ekf"]), pick(levels, ["ekf-rie"])];
  const bare = pick(levels, ["ekf-retraction"]);
  if (!plain || !manifold) return null;
  const found = `EKFRie is ${compared(manifold.position, plain.position)} EKF`;
  const telling = apart(plain.position, manifold.position) >= TELLING;
  return { weight: 80, text: `${found}${bare ? alone(bare, manifold, telling) : ""}.` };
}

/** "9 % better than", "5 times as good as". */
function compared(mine: number, other: number): string {
  const ratio = other / mine;
  if (Math.abs(ratio - 1) < TELLING) return "as good as";
  if (ratio >= 2) return `${formatTimes(ratio)} times as good as`;
  if (ratio <= 0.5) return `${formatTimes(1 / ratio)} times as bad as`;
  const percent = Math.max(1, Math.round(100 * Math.abs(mine / other - 1)));
  return `${percent} % ${ratio > 1 ? "better" : "worse"} than`;
}

/** How much of it retraction does without transport; `telling` where there is something to do. */
function alone(bare: Level, manifold: Level, telling: boolean): string {
  const difference = apart(bare.position, manifold.position);
  if (difference >= SAME) return `; retraction alone is ${compared(bare.position, manifold.position)} it`;
  const digits = Math.min(MOST_DIGITS, Math.floor(-Math.log10(Math.max(difference, 1e-12))));
  const equals = `alone equals it to ${countOf(digits)} digits`;
  return telling ? `, all by retraction: that ${equals}` : `; retraction ${equals}`;
}

/** What an integrator that fits the samples does, or one that does not. */
function integration(levels: readonly Level[], convention: Convention): Finding | null {
  const [euler, exact] = [pick(levels, EULER), pick(levels, EXACT)];
  if (!euler || !exact) return null;
  const ratio = euler.position / exact.position;
  const metres = `${formatReading(exact.position)} m`;
  if (ratio > FAR) {
    const who =
      convention === "mean" ? "whose integration matches ‘mean’ samples" : "which integrates exactly";
    return {
      weight: ratio > LOST ? 84 : 75,
      text: `${exact.label}, ${who}, is ${formatTimes(ratio)} times as good: ${metres}.`,
    };
  }
  if (ratio < 1 / FAR) {
    const why =
      convention === "disc"
        ? "‘disc’ samples match Euler’s rule, not its integration"
        : "the samples match Euler’s rule better";
    return {
      weight: 82,
      text: `${exact.label} is ${formatTimes(1 / ratio)} times as bad (${metres}): ${why}.`,
    };
  }
  return null;
}

function formatTimes(ratio: number): string {
  return ratio < 10 ? ratio.toFixed(1).replace(/\.0$/, "") : String(Math.round(ratio));
}

/** Where the Q-factor turns less well than Euler's rule and a polar factor at the end. */
function orientation(levels: readonly Level[]): Finding | null {
  const [plain, manifold] = [pick(levels, ["ekf"]), pick(levels, ["ekf-rie"])];
  if (!plain || !manifold || manifold.angle / plain.angle < WORSE) return null;
  return {
    weight: manifold.angle / plain.angle > FAR ? 83 : 60,
    text: `EKFRie’s orientation is worse: ${degrees(manifold)} against ${degrees(plain)}.`,
  };
}

function consistency(levels: readonly Level[]): Finding | null {
  const wrong = levels.filter(({ nees }) => nees > WRONG);
  const honest = levels.filter(({ nees }) => nees < RIGHT && nees > 1 / RIGHT);
  if (honest.length > 0 && wrong.length > 0) {
    const [first] = honest;
    return {
      weight: 65,
      text: `${first.label} is off by what it claims: NEES ${first.nees.toFixed(2)} of 1.`,
    };
  }
  if (wrong.length === 0 || wrong.length < levels.length) return null;
  const least = Math.min(...wrong.map(({ nees }) => nees));
  return {
    weight: 40,
    text: `All claim too much: squared errors are ${formatTimes(least)} times the claim and more; P knows the noise only.`,
  };
}

function nearest(levels: readonly Level[]): Finding {
  const best = levels.reduce((one, other) => (other.position < one.position ? other : one));
  return {
    weight: 30,
    text: `Nearest: ${best.label}, ${formatReading(best.position)} m and ${degrees(best)}.`,
  };
}

function degrees({ angle }: Level): string {
  return `${formatReading(angle * DEGREES_PER_RADIAN)}°`;
}
