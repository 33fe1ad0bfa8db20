import type { KinematicsFound } from "../../engine";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import { add, lift, niceBelow, scale, sub, type Vec3 } from "../../scene/geometry";
import type { SceneInput } from "../../scene/input";
import { ARROW_KINDS } from "./handles";
import { ERRORS, hintOf, reach } from "./hints";
import type { AnchorlessRun } from "./run";

/** Where nodes, arrows and estimates of a run are drawn: errors are magnified around the truth. */

export type Input = SceneInput<AnchorlessRun, KinematicsScenario>;

/** Share of the scene's radius that the largest error is drawn as, at most. */
const LARGEST_ERROR = 0.08;

/** How many times larger errors are drawn than they are: as the scenario says, else so that the largest is seen. */
export function errorScale({ run, frame }: Pick<Input, "run" | "frame">): number {
  if (!run) return 1;
  const asked = hintOf(run.scenario, ERRORS);
  if (asked !== null) return asked;
  const largest = Math.max(
    0,
    ...run.trial.estimators.flatMap(({ positionErrors, alignedPositionErrors }) =>
      positionErrors.length > 0 ? [...positionErrors] : [...alignedPositionErrors],
    ),
  );
  if (!(largest > 0)) return 1;
  return Math.max(1, niceBelow((LARGEST_ERROR * frame.radius) / largest));
}

/** The same for the ends of the arrows. */
export function arrowScale({ run, frame }: Pick<Input, "run" | "frame">): number {
  if (!run) return 1;
  const asked = hintOf(run.scenario, ERRORS);
  if (asked !== null) return asked;
  const lengths = ARROW_KINDS.map(({ l }) => reach(run.scenario, l));
  const largest = Math.max(
    0,
    ...run.trial.estimators.flatMap(({ coefficient_errors }) =>
      lengths.map((length, index) => length * (coefficient_errors[index + 1] ?? 0)),
    ),
  );
  return largest > 0 ? Math.max(1, niceBelow((LARGEST_ERROR * frame.radius) / largest)) : 1;
}

/** Row `node` of an instant in K x N x D numbers. */
function rowAt(run: AnchorlessRun, values: Float64Array, step: number, node: number): Vec3 {
  const at = (step * run.anchors.length + node) * run.dimension;
  return lift(values.subarray(at, at + run.dimension));
}

/** Where a node truly is at a step. */
export function truePlace(run: AnchorlessRun, step: number, node: number): Vec3 {
  const middle = run.truth.positions.subarray(step * run.dimension, (step + 1) * run.dimension);
  return add(lift(middle), rowAt(run, run.trial.truth, step, node));
}

/** What an estimator is off at a step, m, not magnified; null where it has no place for the node. */
export function errorAt(run: AnchorlessRun, found: KinematicsFound, step: number, node: number): Vec3 | null {
  if (found.errors.length > 0) return rowAt(run, found.errors, step, node);
  if (found.snapshotErrors.length === 0) return null;
  const error = rowAt(run, found.snapshotErrors, nearestStamp(run, step), node);
  return Number.isFinite(error[0]) ? error : null;
}

/** The stamp nearest to a step. */
export function nearestStamp({ times, trial: { stamps } }: AnchorlessRun, step: number): number {
  const away = (k: number) => Math.abs(stamps[k] - times[step]);
  return stamps.reduce((best, _, k) => (away(k) < away(best) ? k : best), 0);
}

export interface Arrow {
  readonly l: 1 | 2;
  readonly from: Vec3;
  readonly to: Vec3;
}

/** The true arrows at time 0, node by node. */
export function trueArrows({ room, handles }: Pick<Input, "room" | "handles">): Arrow[][] {
  const tips = new Map(handles.map(({ id, place }) => [id, place]));
  return room.anchors.map((anchor, node) =>
    ARROW_KINDS.flatMap(({ l, name }) => {
      const tip = tips.get(`${name} ${node}`);
      return tip ? [{ l, from: lift(anchor), to: lift(tip) }] : [];
    }),
  );
}

/** An arrow as an estimator found it: its ends are as much off as its errors, magnified. */
export function foundArrow(
  run: AnchorlessRun,
  found: KinematicsFound,
  node: number,
  { l, from, to }: Arrow,
  magnification: number,
): Arrow {
  const errorOf = (of: number): Vec3 => {
    const values = found.coefficientErrors[of];
    if (values.length === 0) return [0, 0, 0];
    return lift(values.subarray(node * run.dimension, (node + 1) * run.dimension));
  };
  const tip = add(errorOf(0), scale(errorOf(l), reach(run.scenario, l)));
  return { l, from: add(from, scale(errorOf(0), magnification)), to: add(to, scale(tip, magnification)) };
}

const trails = new WeakMap<AnchorlessRun, Float32Array[]>();

/** The way of each node over the interval, three coordinates an instant. */
export function trailsOf(run: AnchorlessRun): readonly Float32Array[] {
  const known = trails.get(run);
  if (known) return known;
  const all = run.anchors.map((_, node) =>
    Float32Array.from([...run.times.keys()].flatMap((step) => [...truePlace(run, step, node)])),
  );
  trails.set(run, all);
  return all;
}

/** A vector across an arrow, in the plane that is seen best: on the floor. */
export function across({ from, to }: Arrow): Vec3 {
  const [x, y] = sub(to, from);
  return [-y, x, 0];
}
