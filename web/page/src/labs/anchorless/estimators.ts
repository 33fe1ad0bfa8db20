import type { Switch, SwitchGroup } from "../../controls/switches";
import type { KinematicsName } from "../../generated/KinematicsName";
import type { PlotLine } from "../../plots/spec";
import type { Shape } from "../../scene/draw-list";

/** An estimator as the page names and draws it, everywhere the same. */
export interface KinematicsEstimator extends Switch<KinematicsName> {
  /** Whether it reads accelerometers. */
  readonly senses: boolean;
  readonly dash: readonly number[];
}

const [DASH, LONG, DOTS] = [
  [7, 4],
  [14, 4],
  [2, 4],
];

/** The four solvers of the second stage of both algorithms: one colour each, told apart by mark and dash. */
function solvers(algorithm: 1 | 2, token: string, marks: readonly Shape[]): KinematicsEstimator[] {
  const of = (
    solver: "rank1" | "so" | "lifted" | "literal",
    label: string,
    meaning: string,
    index: number,
    dash: readonly number[],
  ): KinematicsEstimator => ({
    name: `algorithm-${algorithm}-${solver}`,
    label: `Alg. ${algorithm}, ${label}`,
    meaning,
    senses: algorithm === 2,
    token,
    mark: marks[index],
    dash,
  });
  return [
    of("rank1", "rank one", "no division", 0, []),
    of("so", "O(D)", "least squares", 1, DASH),
    of("lifted", "lifted", "linear, projected", 2, LONG),
    of("literal", "as printed", "divides by h", 3, DOTS),
  ];
}

export const GROUPS: readonly SwitchGroup<KinematicsEstimator>[] = [
  {
    title: "Algorithm 1: distances",
    entries: solvers(1, "kf", ["square", "triangle", "diamond", "cross"]),
  },
  {
    title: "Algorithm 2: and accelerometers",
    entries: solvers(2, "ortho", ["triangle", "square", "ring", "cross"]),
  },
  {
    title: "Beyond the paper",
    entries: [
      {
        name: "snapshot-sync",
        label: "Snapshot sync",
        meaning: "closed form, any degree",
        senses: false,
        token: "et-kf",
        mark: "diamond",
        dash: [],
      },
      {
        name: "maximum-likelihood",
        label: "ML, distances",
        meaning: "compressed",
        senses: false,
        token: "eskf",
        mark: "disc",
        dash: [],
      },
      {
        name: "maximum-likelihood-full",
        label: "ML, every distance",
        meaning: "the same, slower",
        senses: false,
        token: "eskf",
        mark: "cross",
        dash: DASH,
      },
      {
        name: "maximum-likelihood-accelerometers",
        label: "ML, all readings",
        meaning: "accelerometers too",
        senses: true,
        token: "uc-kf",
        mark: "ring",
        dash: [],
      },
      {
        name: "maximum-likelihood-accelerometers-full",
        label: "ML, every reading",
        meaning: "the same, slower",
        senses: true,
        token: "uc-kf",
        mark: "cross",
        dash: DASH,
      },
    ],
  },
  {
    title: "Baselines",
    entries: [
      {
        name: "multidimensional-scaling",
        label: "MDS of each epoch",
        meaning: "positions alone",
        senses: false,
        token: "eskf-raw",
        mark: "triangle",
        dash: [],
      },
      {
        name: "range-polynomial",
        label: "Polynomial of each range",
        meaning: "B alone",
        senses: false,
        token: "eskf-raw",
        mark: "cross",
        dash: DASH,
      },
    ],
  },
];

export const ESTIMATORS: readonly KinematicsEstimator[] = GROUPS.flatMap(({ entries }) => entries);
export const ORDER = ESTIMATORS.map(({ name }) => name);
/** Switched on with the accelerometers. */
export const SENSING_FIRST: readonly KinematicsName[] = [
  "algorithm-2-rank1",
  "maximum-likelihood-accelerometers",
];

export function estimatorOf(name: KinematicsName): KinematicsEstimator {
  return ESTIMATORS.find((estimator) => estimator.name === name) ?? ESTIMATORS[0];
}

export function senses(enabled: readonly KinematicsName[]): boolean {
  return enabled.some((name) => estimatorOf(name).senses);
}

export function lineLook(name: KinematicsName): Omit<PlotLine, "values" | "standardErrors"> {
  const { label, token, mark, dash } = estimatorOf(name);
  return { name, label, token, mark, dash, events: [] };
}

/** The bounds by what they know. */
export const BOUNDS = [
  { kind: "distances", label: "CRB, distances", dash: DASH },
  { kind: "accelerometers", label: "CRB, all readings", dash: DOTS },
] as const;

export type BoundKind = (typeof BOUNDS)[number]["kind"];

export function boundLook(kind: BoundKind): Omit<PlotLine, "values" | "standardErrors"> {
  const { label, dash } = BOUNDS.find((bound) => bound.kind === kind)!;
  return { name: `crb-${kind}`, label, token: "bound", mark: null, dash, events: [] };
}

/** The bounds that belong to what is switched on. */
export function boundKinds(enabled: readonly KinematicsName[]): BoundKind[] {
  return senses(enabled) ? ["distances", "accelerometers"] : ["distances"];
}

export function boundOf(name: KinematicsName): BoundKind {
  return estimatorOf(name).senses ? "accelerometers" : "distances";
}
