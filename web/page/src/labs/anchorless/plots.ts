import type { KinematicsBounds, KinematicsFound } from "../../engine";
import type { KinematicsName } from "../../generated/KinematicsName";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import { type PlotAxis, type PlotLine, type PlotSpec, timeAxis } from "../../plots/spec";
import { boundKinds, boundLook, lineLook } from "./estimators";
import type { AnchorlessRun } from "./run";
import { spectrumPlots } from "./spectrum";

/** What every plot is unless it says otherwise. */
export const PLAIN = { bands: [], threshold: null, scale: "log", note: null } as const;
export const ONE = { name: "anchorless-one", shortTitle: "One alignment", unit: "m" } as const;
export const EACH = { name: "anchorless-each", shortTitle: "Aligned at each t", unit: "m" } as const;

export function plots(_scenario: KinematicsScenario, run: AnchorlessRun): PlotSpec[] {
  const common = { ...PLAIN, x: timeAxis(run.times) };
  const { estimators } = run.trial;
  const { enabled } = run.scenario.estimators;
  return [
    {
      ...common,
      ...ONE,
      title: "Error, one alignment",
      lines: [
        ...boundLines(run.bounds, enabled, "positions"),
        ...lines(estimators, (found) => found.positionErrors),
      ],
    },
    {
      ...common,
      ...EACH,
      title: "Error, aligned at each t",
      lines: [
        ...boundLines(run.bounds, enabled, "aligned_positions"),
        ...lines(estimators, (found) => found.alignedPositionErrors),
      ],
    },
    ...spectrumPlots(run),
  ];
}

function lines(all: readonly KinematicsFound[], pick: (found: KinematicsFound) => Float64Array): PlotLine[] {
  return all
    .filter((found) => pick(found).length > 0)
    .map((found) => ({ ...lineLook(found.name), values: pick(found), standardErrors: null }));
}

/** The bounds over time that belong to what is switched on. */
export function boundLines(
  bounds: KinematicsBounds,
  enabled: readonly KinematicsName[],
  of: "positions" | "aligned_positions",
): PlotLine[] {
  return boundKinds(enabled)
    .filter((kind) => bounds[kind][of].length > 0)
    .map((kind) => ({
      ...boundLook(kind),
      values: Float64Array.from(bounds[kind][of]),
      standardErrors: null,
    }));
}

/** Along it lie the numbers 1, 2, … */
export function countAxis(name: string, count: number): PlotAxis {
  const values = Float64Array.from({ length: count }, (_, index) => index + 1);
  return { name, unit: "", values, scale: "linear", timed: false, now: null };
}
