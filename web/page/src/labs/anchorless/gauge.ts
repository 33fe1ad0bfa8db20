import type { KinematicsScenario } from "../../generated/KinematicsScenario";

/** What distances cannot see: the whole network turned about a point, mirrored, and shifted. It is a hint of the page. */
export interface Gauge {
  /** Counter-clockwise, in space about the vertical. */
  readonly degrees: number;
  /** In x, before the turn. */
  readonly mirrored: boolean;
  /** Metres, as many as there are dimensions. */
  readonly shift: readonly number[];
  /** The point that is turned about and mirrored at, chosen when the gauge is first used. */
  readonly pivot: readonly number[];
}

export type Points = KinematicsScenario["coefficients"][number];
type Scenario = Pick<KinematicsScenario, "coefficients" | "view">;

/** The gauge of a scenario; a hint may be anything, and one that fits it not is as none. */
export function gaugeOf(scenario: Scenario): Gauge {
  const dimension = dimensionOf(scenario);
  const hint = scenario.view?.["gauge"] as Partial<Gauge> | null | undefined;
  const vector = (value: unknown): value is number[] =>
    Array.isArray(value) && value.length === dimension && value.every(Number.isFinite);
  const none = { degrees: 0, mirrored: false, shift: Array<number>(dimension).fill(0) };
  if (hint && Number.isFinite(hint.degrees) && vector(hint.shift) && vector(hint.pivot))
    return {
      degrees: hint.degrees!,
      mirrored: hint.mirrored === true,
      shift: hint.shift,
      pivot: hint.pivot,
    };
  return { ...none, pivot: middleOf(scenario.coefficients[0]).map(Math.round) };
}

export function isIdentity({ degrees, mirrored, shift }: Gauge): boolean {
  return degrees === 0 && !mirrored && shift.every((value) => value === 0);
}

/** The scenario seen in another gauge; none is no hint at all. */
export function withGauge<S extends Scenario>(scenario: S, change: Partial<Gauge>): S {
  const gauge = { ...gaugeOf(scenario), ...change };
  return { ...scenario, view: { ...scenario.view, gauge: isIdentity(gauge) ? undefined : gauge } };
}

/** A velocity or an acceleration of the scenario as it is seen. */
export function turned({ degrees, mirrored }: Gauge, vector: readonly number[]): number[] {
  const [cosine, sine] = cosineAndSine(degrees);
  const [x, y, ...z] = [mirrored ? -vector[0] : vector[0], ...vector.slice(1)];
  return [cosine * x - sine * y, sine * x + cosine * y, ...z];
}

/** And back. */
export function turnedBack({ degrees, mirrored }: Gauge, vector: readonly number[]): number[] {
  const [cosine, sine] = cosineAndSine(degrees);
  const [x, y, ...z] = vector;
  const straight = cosine * x + sine * y;
  return [mirrored ? -straight : straight, cosine * y - sine * x, ...z];
}

/** A place of the scenario as it is seen. */
export function placed(gauge: Gauge, point: readonly number[]): number[] {
  const { pivot, shift } = gauge;
  const around = turned(
    gauge,
    point.map((value, axis) => value - pivot[axis]),
  );
  return around.map((value, axis) => value + pivot[axis] + shift[axis]);
}

/** And back. */
export function placedBack(gauge: Gauge, point: readonly number[]): number[] {
  const { pivot, shift } = gauge;
  const around = point.map((value, axis) => value - pivot[axis] - shift[axis]);
  return turnedBack(gauge, around).map((value, axis) => value + pivot[axis]);
}

/** Quarter turns are exact. */
function cosineAndSine(degrees: number): readonly [number, number] {
  const quarter = (((degrees / 90) % 4) + 4) % 4;
  if (Number.isInteger(quarter))
    return (
      [
        [1, 0],
        [0, 1],
        [-1, 0],
        [0, -1],
      ] as const
    )[quarter];
  const angle = (degrees * Math.PI) / 180;
  return [Math.cos(angle), Math.sin(angle)];
}

const seenBefore = new WeakMap<object, KinematicsScenario["coefficients"]>();

/** The coefficients of the motion as it is seen. */
export function seen(scenario: Scenario): KinematicsScenario["coefficients"] {
  const gauge = gaugeOf(scenario);
  if (isIdentity(gauge)) return scenario.coefficients;
  const known = seenBefore.get(scenario);
  if (known) return known;
  const [positions, ...others] = scenario.coefficients;
  const all = [
    positions.map((point) => placed(gauge, point)),
    ...others.map((points) => points.map((vector) => turned(gauge, vector))),
  ];
  seenBefore.set(scenario, all);
  return all;
}

/** How far the gauge changes what should not change, over some instants. */
export interface GaugeEvidence {
  /** Largest change of a distance between two nodes, m. */
  readonly distance: number;
  /** Largest change of the length of a velocity or an acceleration, m/s^l. */
  readonly arrow: number;
  /** Largest difference between the turns of two arrows, degrees; 0 where fewer than two have a direction. */
  readonly turn: number;
}

export function evidenceOf(scenario: Scenario, times: ArrayLike<number>): GaugeEvidence {
  const [before, after] = [scenario.coefficients, seen(scenario)];
  let distance = 0;
  for (const time of Array.from(times)) {
    const [here, there] = [distancesAt(before, time), distancesAt(after, time)];
    here.forEach((value, pair) => (distance = Math.max(distance, Math.abs(value - there[pair]))));
  }
  const arrows = before
    .slice(1)
    .flatMap((points, l) => points.map((vector, node) => [vector, after[l + 1][node]] as const));
  const lengths = arrows.map(([one, other]) => Math.abs(Math.hypot(...one) - Math.hypot(...other)));
  return { distance, arrow: Math.max(0, ...lengths), turn: unevenness(arrows, gaugeOf(scenario).mirrored) };
}

/** Between all arrows on the floor: each is turned by the same angle, a mirrored one after it was mirrored. */
function unevenness(arrows: readonly (readonly [number[], number[]])[], mirrored: boolean): number {
  const turns = arrows
    .filter(([[x, y]]) => Math.hypot(x, y) > 0)
    .map(([[x, y], [u, v]]) => {
      const from = Math.atan2(y, mirrored ? -x : x);
      return (((Math.atan2(v, u) - from) * 180) / Math.PI + 720) % 360;
    });
  // Turns of nearly 0 and nearly 360 degrees are the same.
  const [first = 0] = turns;
  return Math.max(0, ...turns.map((turn) => Math.abs(((turn - first + 540) % 360) - 180)));
}

function distancesAt(coefficients: KinematicsScenario["coefficients"], time: number): number[] {
  const points = pointsAt(coefficients, time);
  return points.flatMap((a, i) =>
    points.slice(i + 1).map((b) => Math.hypot(...a.map((value, axis) => value - b[axis]))),
  );
}

/** `sum_l Y_l t^l/l!`, node by node. */
export function pointsAt(coefficients: KinematicsScenario["coefficients"], time: number): Points {
  return coefficients[0].map((point, node) =>
    point.map((_, axis) =>
      coefficients.reduceRight((sum, points, l) => points[node][axis] + (sum * time) / (l + 1), 0),
    ),
  );
}

export function middleOf(points: Points): number[] {
  return points[0].map((_, axis) => points.reduce((sum, point) => sum + point[axis], 0) / points.length);
}

export function dimensionOf({ coefficients }: Pick<KinematicsScenario, "coefficients">): number {
  return coefficients[0][0].length;
}

/** Without the noise of the last bits, as it is typed and shown. */
export function clean(values: readonly number[]): number[] {
  return values.map((value) => Number(value.toFixed(9)) + 0);
}
