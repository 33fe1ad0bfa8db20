/** How the curves of figures look: the same as in the pictures of the command line. */
import type { Curve } from "../generated/Curve";
import type { PlotLine } from "../plots/spec";
import type { Shape } from "../scene/draw-list";
import { MARKS } from "../theme/palette";

/** Snapshot estimators share the colours of the trackers: no figure shows both. */
const LOCALIZERS: Record<string, { token: string; mark: Shape }> = {
  "classical-ls": { token: "eskf-raw", mark: "cross" },
  ls: { token: "kf", mark: "ring" },
  "suc-ls": { token: "ortho", mark: "square" },
  "suc-tls": { token: "ortho", mark: "square" },
  "suc-ls-weighted": { token: "ortho", mark: "disc" },
  "ouc-ls": { token: "uc-kf", mark: "triangle" },
  "ouc-tls-printed": { token: "et-kf", mark: "diamond" },
  "ouc-tls": { token: "eskf", mark: "disc" },
  "gauss-newton": { token: "eskf-raw", mark: "square" },
  "maximum-likelihood": { token: "eskf-raw", mark: "disc" },
};

const DASH = [7, 4];
const DOTS = [2, 4];
const DASH_DOT = [10, 3, 2, 3];
const DASHES: Record<string, readonly number[]> = {
  posterior_crb_raw: DASH_DOT,
  linear_posterior_crb: DOTS,
  classical_crb: DASH_DOT,
  crb: DOTS,
};

type Look = Pick<PlotLine, "token" | "mark" | "dash">;

export function lookOf({ name, kind }: Pick<Curve, "name" | "kind">): Look {
  if (kind === "bound") return { token: "bound", mark: null, dash: DASHES[name] ?? DASH };
  const tracker = MARKS[name] && { token: name, mark: MARKS[name] };
  const { token, mark } = tracker ?? LOCALIZERS[name] ?? { token: "ink-soft", mark: "disc" };
  return kind === "covariance" ? { token, mark: null, dash: DOTS } : { token, mark, dash: [] };
}
