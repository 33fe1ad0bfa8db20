import type { Switch, SwitchGroup } from "../../controls/switches";
import type { FilterName } from "../../generated/FilterName";
import type { PlotLine } from "../../plots/spec";

/** A filter as the page names and draws it, everywhere the same. */
export interface Filter extends Switch<FilterName> {
  readonly dash: readonly number[];
}

const DASH = [7, 4];

/** Those that keep the nine entries of R, and the yardsticks that keep a rotation. A dashed one is drawn over the one before it, whose colour it shares or whose numbers it often has. */
export const GROUPS: readonly SwitchGroup<Filter>[] = [
  {
    title: "R by Euler’s rule, extended",
    entries: [
      { name: "ekf", label: "EKF", meaning: "as printed", token: "kf", mark: "ring", dash: [] },
      {
        name: "ekf-full",
        label: "EKF, full Jacobian",
        meaning: "∂(g u)/∂X too",
        token: "kf",
        mark: "cross",
        dash: DASH,
      },
      {
        name: "ekf-retraction",
        label: "EKF, retraction only",
        meaning: "R a rotation, P left",
        token: "ortho",
        mark: "square",
        dash: [],
      },
      {
        name: "ekf-rie",
        label: "EKFRie",
        meaning: "retraction and transport",
        token: "uc-kf",
        mark: "triangle",
        dash: DASH,
      },
    ],
  },
  {
    title: "R by Euler’s rule, unscented",
    entries: [
      { name: "ukf", label: "UKF", meaning: "sigma points", token: "et-kf", mark: "diamond", dash: [] },
      {
        name: "ukf-rie",
        label: "UKFRie",
        meaning: "retraction and transport",
        token: "et-kf",
        mark: "triangle",
        dash: DASH,
      },
    ],
  },
  {
    title: "Integrated exactly",
    entries: [
      { name: "mekf", label: "MEKF", meaning: "error-state", token: "eskf", mark: "disc", dash: [] },
      { name: "lie-kf", label: "LIEKF", meaning: "invariant", token: "eskf", mark: "diamond", dash: DASH },
      {
        name: "tight",
        label: "MEKF on ranges",
        meaning: "no fixes between",
        token: "eskf-raw",
        mark: "cross",
        dash: [2, 3],
      },
    ],
  },
];

export const FILTERS: readonly Filter[] = GROUPS.flatMap(({ entries }) => entries);

/** Enough to tell where the gain comes from. */
export const SHOWN_FIRST: readonly FilterName[] = ["ekf", "ekf-retraction", "ekf-rie", "mekf"];

export function filterOf(name: FilterName): Filter {
  return FILTERS.find((filter) => filter.name === name) ?? FILTERS[0];
}

export function lineLook(name: FilterName): Omit<PlotLine, "values" | "standardErrors"> {
  const { label, token, mark, dash } = filterOf(name);
  return { name, label, token, mark, dash, events: [] };
}
