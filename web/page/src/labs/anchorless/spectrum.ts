import type { PlotLine, PlotSpec } from "../../plots/spec";
import { countAxis, PLAIN } from "./plots";
import type { AnchorlessRun } from "./run";

/** Below this share of the largest a true eigenvalue is rounding: there are D that are not zero. */
const ROUNDING = 1e-9;

/** Eigenvalues of the Gram matrices: D of them stand out, the others are noise. */
export function spectrumPlots({ spectrum, anchors, dimension, scenario }: AnchorlessRun): PlotSpec[] {
  const common = { ...PLAIN, x: countAxis("eigenvalue", anchors.length) };
  const { degree } = scenario.estimators;
  const note = `the first ${dimension} are kept; crosses: negative ones, by their size`;
  return [
    {
      ...common,
      name: "anchorless-spectrum",
      title: "Spectrum of the positions’ Gram matrix",
      shortTitle: "Spectrum, positions",
      unit: "m²",
      note,
      lines: [
        ...dots("epoch", "one epoch", "range", "ring", spectrum.epoch),
        ...dots("fitted", "fitted at t = 0", "uc-kf", "square", spectrum.fitted),
        ...truth(spectrum.truth),
      ],
    },
    {
      ...common,
      name: "anchorless-spectrum-top",
      title:
        degree === 2 ? "Spectrum of the accelerations’ Gram matrix" : `Spectrum of Y${degree}ᵀ Y${degree}`,
      shortTitle: degree === 2 ? "Spectrum, accelerations" : `Spectrum, Y${degree}`,
      unit: degree === 0 ? "m²" : degree === 1 ? "m²/s²" : `m²/s^${2 * degree}`,
      note,
      lines: [
        ...dots("fitted", "fitted from distances", "uc-kf", "square", spectrum.fitted_top),
        ...truth(spectrum.truth_top),
      ],
    },
  ];
}

/** Those above zero, and those below by their size: noise has both. */
function dots(
  name: string,
  label: string,
  token: string,
  mark: "ring" | "square",
  values: readonly number[],
): PlotLine[] {
  const part = (sign: 1 | -1) =>
    Float64Array.from(values, (value) => (sign * value > 0 ? sign * value : NaN));
  const common = { token, dash: [], standardErrors: null, events: [], points: true };
  return [
    { ...common, name, label, mark, values: part(1) },
    {
      ...common,
      name: `${name}-negative`,
      label: `${label}, negative`,
      mark: "cross" as const,
      values: part(-1),
    },
  ].filter((line) => line.values.some(Number.isFinite));
}

function truth(values: readonly number[]): PlotLine[] {
  const least = ROUNDING * (values[0] ?? 0);
  const shown = Float64Array.from(values, (value) => (value > least ? value : NaN));
  if (!shown.some(Number.isFinite)) return [];
  return [
    {
      name: "truth",
      label: "truth",
      token: "truth",
      mark: "disc",
      dash: [],
      values: shown,
      standardErrors: null,
      events: [],
      points: true,
    },
  ];
}
