/** How the curves of figures look: as in the labs, and in the pictures of the command line. */
import type { Curve } from "../generated/Curve";
import { BOUND_LOOKS as SNAPSHOT_BOUNDS, LOCALIZERS } from "../labs/localize/localizers";
import { BOUND_LOOKS as TRACK_BOUNDS } from "../labs/track/plots";
import type { PlotLine } from "../plots/spec";
import { MARKS } from "../theme/palette";

const DASH = [7, 4];
const DOTS = [2, 4];

/** Those of the filters of indoor tracking; a dashed one is drawn over another whose numbers it often has. */
const FILTERS: Record<string, Look> = {
  ekf: { token: "kf", mark: "ring", dash: [] },
  "ekf-rie": { token: "uc-kf", mark: "triangle", dash: DASH },
  ukf: { token: "et-kf", mark: "diamond", dash: [] },
  "ukf-rie": { token: "et-kf", mark: "triangle", dash: DASH },
  mekf: { token: "eskf", mark: "disc", dash: [] },
};

type Look = Pick<PlotLine, "token" | "mark" | "dash">;

export function lookOf({ name, kind }: Pick<Curve, "name" | "kind">): Look {
  if (kind === "bound")
    return { token: "bound", mark: null, dash: { ...TRACK_BOUNDS, ...SNAPSHOT_BOUNDS }[name]?.dash ?? DASH };
  const { token, mark, dash } = estimatorLook(name);
  return kind === "covariance" ? { token, mark: null, dash: DOTS } : { token, mark, dash };
}

/** Snapshot estimators share the colours of the trackers: no figure shows both. */
function estimatorLook(name: string): Look {
  if (FILTERS[name]) return FILTERS[name];
  if (MARKS[name]) return { token: name, mark: MARKS[name], dash: [] };
  const localizer = LOCALIZERS.find((each) => each.name === name);
  return { token: localizer?.token ?? "ink-soft", mark: localizer?.mark ?? "disc", dash: [] };
}
