import type { Shape } from "../../scene/draw-list";
import type { PlotLine, PlotSpec } from "../../plots/spec";
import { countAxis, PLAIN } from "./plots";
import type { AnchorlessRun } from "./run";

/** Below this share of the largest an eigenvalue is rounding: one is always zero, and of the truth all but D. */
const ROUNDING = 1e-12;

/** Sizes of the eigenvalues of the Gram matrices: D of them stand out, the others are noise. */
export function spectrumPlots({ spectrum, anchors, dimension, scenario }: AnchorlessRun): PlotSpec[] {
  const common = {
    ...PLAIN,
    x: countAxis("eigenvalue", anchors.length),
    // The curves fall from the left and rise to the right.
    note: `${dimension} kept; last: negative`,
    noteInMiddle: true,
  };
  const { degree } = scenario.estimators;
  const top = degree === 2 ? "accelerations" : `Y${degree}`;
  return [
    {
      ...common,
      name: "anchorless-spectrum",
      title: "Spectrum: positions",
      shortTitle: "Spectrum, positions",
      unit: "m²",
      lines: [
        ...sizes("epoch", "one epoch", "range", "ring", [2, 3], spectrum.epoch),
        ...sizes("fitted", "fit of all", "uc-kf", "square", [], spectrum.fitted),
        ...sizes("truth", "truth", "truth", "disc", [7, 4], spectrum.truth),
      ],
    },
    {
      ...common,
      name: "anchorless-spectrum-top",
      title: `Spectrum: ${top}`,
      shortTitle: `Spectrum, ${top}`,
      unit: ["m²", "m²/s²", "m²/s⁴"][degree] ?? `m²/s^${2 * degree}`,
      lines: [
        ...sizes("fitted", "fit of all", "uc-kf", "square", [], spectrum.fitted_top),
        ...sizes("truth", "truth", "truth", "disc", [7, 4], spectrum.truth_top),
      ],
    },
  ];
}

/** What is not rounding, whatever its sign. */
function sizes(
  name: string,
  label: string,
  token: string,
  mark: Shape,
  dash: readonly number[],
  eigenvalues: readonly number[],
): PlotLine[] {
  const least = ROUNDING * Math.max(0, ...eigenvalues.map(Math.abs));
  const values = Float64Array.from(eigenvalues, (value) => (Math.abs(value) > least ? Math.abs(value) : NaN));
  if (!values.some(Number.isFinite)) return [];
  return [{ name, label, token, mark, dash, values, standardErrors: null, events: [] }];
}
