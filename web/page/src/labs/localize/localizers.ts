import type { Switch } from "../../controls/switches";
import type { LocalizerName } from "../../generated/LocalizerName";
import type { PlotLine } from "../../plots/spec";

/** A localizer as the page names and draws it, everywhere the same. */
export type Localizer = Switch<LocalizerName>;

/** In the order in which they are listed; the looks are those of the command line's figures. */
export const LOCALIZERS: readonly Localizer[] = [
  {
    name: "classical-ls",
    label: "classical LS",
    meaning: "sensor by sensor",
    token: "eskf-raw",
    mark: "cross",
  },
  { name: "ls", label: "LS", meaning: "any matrix Q", token: "kf", mark: "ring" },
  { name: "suc-ls", label: "SUC-LS", meaning: "positions, then Q", token: "ortho", mark: "square" },
  {
    name: "suc-ls-weighted",
    label: "weighted SUC-LS",
    meaning: "rows weighted",
    token: "ortho",
    mark: "disc",
  },
  { name: "ouc-ls", label: "OUC-LS", meaning: "optimal, by Newton", token: "uc-kf", mark: "triangle" },
  { name: "suc-tls", label: "SUC-TLS", meaning: "equals SUC-LS", token: "ortho", mark: "square" },
  {
    name: "ouc-tls-printed",
    label: "printed OUC-TLS",
    meaning: "σ_e = 1 m",
    token: "et-kf",
    mark: "diamond",
  },
  { name: "ouc-tls", label: "OUC-TLS", meaning: "σ_e as told", token: "eskf", mark: "disc" },
  {
    name: "gauss-newton",
    label: "Gauss-Newton step",
    meaning: "one, from SUC-LS",
    token: "eskf-raw",
    mark: "square",
  },
  {
    name: "maximum-likelihood",
    label: "ML",
    meaning: "on the ranges",
    token: "eskf-raw",
    mark: "disc",
  },
];

export function lookOf(name: LocalizerName): Localizer {
  return LOCALIZERS.find((localizer) => localizer.name === name) ?? LOCALIZERS[0];
}

/** Bounds share a colour and are told apart by their dashes; the engine's labels are long, these fit a table. */
export const BOUND_LOOKS: Record<string, Pick<PlotLine, "label" | "dash">> = {
  uc_crb: { label: "UC-CRB", dash: [7, 4] },
  uc_crb_raw: { label: "UC-CRB, raw ranges", dash: [4, 2] },
  crb: { label: "CRB, any matrix", dash: [2, 4] },
  classical_crb: { label: "CRB, each sensor", dash: [10, 3, 2, 3] },
};

const ON_RAW_RANGES: readonly string[] = ["gauss-newton", "maximum-likelihood"];

/** The bounds that say something about those that run, most telling first. */
export function boundsFor(enabled: readonly string[]): string[] {
  const raw = enabled.some((name) => ON_RAW_RANGES.includes(name));
  const classical = enabled.includes("classical-ls");
  return Object.keys(BOUND_LOOKS).filter(
    (name) => (raw || name !== "uc_crb_raw") && (classical || name !== "classical_crb"),
  );
}

/** The bound for what the localizer knows. */
export function boundOf(name: string): string {
  if (name === "classical-ls") return "classical_crb";
  if (name === "ls") return "crb";
  return ON_RAW_RANGES.includes(name) ? "uc_crb_raw" : "uc_crb";
}
