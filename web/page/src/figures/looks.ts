/** How the curves of figures look: as in the labs, and in the pictures of the command line. */
import type { Curve } from "../generated/Curve";
import { BOUNDS as KINEMATICS_BOUNDS, ESTIMATORS as KINEMATICS } from "../labs/anchorless/estimators";
import { FILTERS } from "../labs/indoor/filters";
import { BOUND_LOOKS as SNAPSHOT_BOUNDS, LOCALIZERS } from "../labs/localize/localizers";
import { BOUND_LOOKS as TRACK_BOUNDS } from "../labs/track/plots";
import type { PlotLine } from "../plots/spec";
import { MARKS } from "../theme/palette";

const DASH = [7, 4];
const DOTS = [2, 4];

/** Polynomials of ranges by their degree, of which the lab shows one at a time. */
const RANGE_POLYNOMIALS: Record<string, Look> = {
  "range-polynomial-2": { token: "eskf-raw", mark: "cross", dash: [] },
  "range-polynomial-3": { token: "eskf", mark: "disc", dash: [] },
  "range-polynomial-4": { token: "et-kf", mark: "diamond", dash: DASH },
  "range-polynomial-5": { token: "uc-kf", mark: "square", dash: DASH },
  "range-polynomial-6": { token: "uc-kf", mark: "ring", dash: [] },
};

type Look = Pick<PlotLine, "token" | "mark" | "dash">;

const BOUNDS: Record<string, { readonly dash: readonly number[] } | undefined> = {
  ...TRACK_BOUNDS,
  ...SNAPSHOT_BOUNDS,
  ...Object.fromEntries(KINEMATICS_BOUNDS.map(({ kind, dash }) => [`crb-${kind}`, { dash }])),
};

export function lookOf({ name, kind }: Pick<Curve, "name" | "kind">): Look {
  if (kind === "bound") return { token: "bound", mark: null, dash: BOUNDS[name]?.dash ?? DASH };
  const { token, mark, dash } = estimatorLook(name);
  return kind === "covariance" ? { token, mark: null, dash: DOTS } : { token, mark, dash };
}

/** Snapshot estimators share the colours of the trackers: no figure shows both. */
function estimatorLook(name: string): Look {
  const own: Look | undefined =
    FILTERS.find((filter) => filter.name === name) ??
    KINEMATICS.find((estimator) => kinematicsCurve(estimator.name) === name) ??
    RANGE_POLYNOMIALS[name];
  if (own) return own;
  if (MARKS[name]) return { token: name, mark: MARKS[name], dash: [] };
  const localizer = LOCALIZERS.find((each) => each.name === name);
  return { token: localizer?.token ?? "ink-soft", mark: localizer?.mark ?? "disc", dash: [] };
}

/** An estimator of relative kinematics as figures call it: "maximum-likelihood" is one of Localize. */
function kinematicsCurve(name: string): string {
  return name === "maximum-likelihood" ? "maximum-likelihood-distances" : name;
}
