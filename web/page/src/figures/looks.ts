/** How the curves of figures look: as in the labs, and in the pictures of the command line. */
import type { Curve } from "../generated/Curve";
import { FILTERS } from "../labs/indoor/filters";
import { BOUND_LOOKS as SNAPSHOT_BOUNDS, LOCALIZERS } from "../labs/localize/localizers";
import { BOUND_LOOKS as TRACK_BOUNDS } from "../labs/track/plots";
import type { PlotLine } from "../plots/spec";
import { MARKS } from "../theme/palette";

const DASH = [7, 4];
const DOTS = [2, 4];

/** Those of relative kinematics; dashed ones share a colour or, often, the numbers of another. */
const KINEMATICS: Record<string, Look> = {
  "algorithm-1-rank1": { token: "kf", mark: "square", dash: [] },
  "algorithm-1-literal": { token: "kf", mark: "cross", dash: DASH },
  "algorithm-2-rank1": { token: "ortho", mark: "triangle", dash: [] },
  "algorithm-2-so": { token: "ortho", mark: "square", dash: DASH },
  "algorithm-2-literal": { token: "ortho", mark: "cross", dash: DASH },
  "snapshot-sync": { token: "et-kf", mark: "diamond", dash: [] },
  "maximum-likelihood-distances": { token: "eskf", mark: "disc", dash: [] },
  "maximum-likelihood-accelerometers": { token: "uc-kf", mark: "ring", dash: [] },
  "multidimensional-scaling": { token: "eskf-raw", mark: "triangle", dash: [] },
  "range-polynomial-2": { token: "eskf-raw", mark: "cross", dash: [] },
  "range-polynomial-3": { token: "eskf", mark: "disc", dash: [] },
  "range-polynomial-4": { token: "et-kf", mark: "diamond", dash: DASH },
  "range-polynomial-6": { token: "uc-kf", mark: "ring", dash: [] },
};
const KINEMATICS_BOUNDS: Record<string, { dash: number[] }> = {
  "crb-distances": { dash: DASH },
  "crb-accelerometers": { dash: DOTS },
};

type Look = Pick<PlotLine, "token" | "mark" | "dash">;

const BOUNDS: Record<string, { readonly dash: readonly number[] } | undefined> = {
  ...TRACK_BOUNDS,
  ...SNAPSHOT_BOUNDS,
  ...KINEMATICS_BOUNDS,
};

export function lookOf({ name, kind }: Pick<Curve, "name" | "kind">): Look {
  if (kind === "bound") return { token: "bound", mark: null, dash: BOUNDS[name]?.dash ?? DASH };
  const { token, mark, dash } = estimatorLook(name);
  return kind === "covariance" ? { token, mark: null, dash: DOTS } : { token, mark, dash };
}

/** Snapshot estimators share the colours of the trackers: no figure shows both. */
function estimatorLook(name: string): Look {
  const own: Look | undefined = FILTERS.find((filter) => filter.name === name) ?? KINEMATICS[name];
  if (own) return own;
  if (MARKS[name]) return { token: name, mark: MARKS[name], dash: [] };
  const localizer = LOCALIZERS.find((each) => each.name === name);
  return { token: localizer?.token ?? "ink-soft", mark: localizer?.mark ?? "disc", dash: [] };
}
