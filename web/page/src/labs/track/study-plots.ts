import { DEGREES_PER_RADIAN } from "../../controls/format";
import { type PlotLine, type PlotSpec, timeAxis } from "../../plots/spec";
import type { Curve, EstimatorCurves, StudyCurves } from "../../study";
import {
  boundLineLook,
  CONSISTENCY,
  estimatorLook,
  INNOVATION,
  NIS_NOTE,
  ORIENTATION,
  PLAIN,
  POSITION,
  settledNis,
  shownOf,
} from "./plots";
import { neesBands, nisBands } from "../../plots/consistency-bands";

/** The plots of one run as averages over trials, each against the bound with the same definition. */
export function studyPlots(times: Float64Array, study: StudyCurves): PlotSpec[] {
  const common = { ...PLAIN, x: timeAxis(times) };
  return [
    {
      ...common,
      ...ORIENTATION,
      title: "Orientation RMSE",
      lines: [
        ...shownOf(study.estimators, study.bounds).map((bound) => ({
          ...boundLineLook(bound),
          ...scaled(bound.angle, DEGREES_PER_RADIAN),
        })),
        ...estimatorLines(study, (estimator) => estimator.angle, DEGREES_PER_RADIAN),
      ],
    },
    {
      ...common,
      ...POSITION,
      title: "Position RMSE",
      lines: [
        ...shownOf(study.estimators, study.bounds).map((bound) => ({
          ...boundLineLook(bound),
          ...scaled(bound.position, 1),
        })),
        ...estimatorLines(study, (estimator) => estimator.position, 1),
      ],
    },
    {
      ...common,
      name: "projections",
      title: "Projected trials",
      shortTitle: "Projections",
      unit: "%",
      scale: "linear",
      lines: estimatorLines(study, (estimator) => estimator.eventRate, 100).filter(
        (line) => line.name === "et-kf",
      ),
      note: "KF-ortho, UC-KF: 100 %",
    },
    {
      ...common,
      ...CONSISTENCY,
      title: "Mean NEES / dof",
      lines: estimatorLines(study, (estimator) => estimator.nees, 1),
      bands: neesBands(study.estimators, study.trials),
    },
    {
      ...common,
      ...INNOVATION,
      title: "Mean NIS / dof",
      lines: estimatorLines(study, ({ nis }) => ({ ...nis, value: settledNis(nis.value) }), 1),
      bands: nisBands(study.estimators, study.trials),
      note: NIS_NOTE,
    },
  ];
}

function estimatorLines(
  study: StudyCurves,
  pick: (estimator: EstimatorCurves) => Curve,
  factor: number,
): PlotLine[] {
  return study.estimators.map((estimator) => ({
    ...estimatorLook(estimator),
    ...scaled(pick(estimator), factor),
  }));
}

function scaled(
  { value, standardError }: Curve,
  factor: number,
): Pick<PlotLine, "values" | "standardErrors"> {
  return {
    values: value.map((number) => number * factor),
    standardErrors: standardError.map((number) => number * factor),
  };
}
