import { DEGREES_PER_RADIAN } from "../../controls/format";
import type { FilterRun } from "../../engine";
import type { IndoorScenario } from "../../generated/IndoorScenario";
import { neesBands } from "../../plots/consistency-bands";
import { type PlotLine, type PlotSpec, timeAxis } from "../../plots/spec";
import { lineLook } from "./filters";
import type { IndoorRun } from "./run";

/** What every plot is unless it says otherwise. */
export const PLAIN = { bands: [], threshold: null, scale: "log", note: null } as const;
export const POSITION = { name: "indoor-position", shortTitle: "Position", unit: "m" } as const;
export const ORIENTATION = { name: "indoor-orientation", shortTitle: "Orientation", unit: "deg" } as const;
export const CONSISTENCY = { name: "indoor-nees", shortTitle: "NEES", unit: "" } as const;
export const STRETCH = {
  name: "indoor-singular-values",
  title: "Singular values of R",
  shortTitle: "R",
  unit: "",
  note: "Dotted: the least.",
} as const;

/** Degrees of freedom of the NEES: orientation, position, velocity. */
const FREEDOM = 9;
/** Singular values nearer to each other than this are one line. */
const ROUNDING = 1e-9;

export function plots(_scenario: IndoorScenario, run: IndoorRun): PlotSpec[] {
  const common = { ...PLAIN, x: timeAxis(run.times) };
  return [
    {
      ...common,
      ...POSITION,
      title: "Position error",
      lines: run.filters.map((filter) => line(filter, filter.positionErrors)),
    },
    {
      ...common,
      ...ORIENTATION,
      title: "Orientation error",
      lines: run.filters.map((filter) => line(filter, filter.orientationErrors, DEGREES_PER_RADIAN)),
    },
    { ...common, ...STRETCH, lines: run.filters.flatMap(stretchOf) },
    {
      ...common,
      ...CONSISTENCY,
      title: "NEES / dof",
      lines: run.filters.map((filter) => line(filter, filter.nees)),
      bands: bandsFor(1),
    },
  ];
}

/** Where 95 % of the mean NEES lie if the covariances are right. */
export function bandsFor(trials: number): PlotSpec["bands"] {
  return neesBands([{ neesDegreesOfFreedom: FREEDOM }], trials);
}

function line({ name }: FilterRun, values: Float64Array, factor = 1): PlotLine {
  return { ...lineLook(name), values: values.map((value) => value * factor), standardErrors: null };
}

/** The largest singular value, and the least where it is another. */
function stretchOf({ name, singularValues }: FilterRun): PlotLine[] {
  const column = (of: number) => singularValues.filter((_, index) => index % 3 === of);
  return stretchLines(
    name,
    { values: column(0), standardErrors: null },
    { values: column(2), standardErrors: null },
  );
}

type Numbers = Pick<PlotLine, "values" | "standardErrors">;

export function stretchLines(name: FilterRun["name"], largest: Numbers, least: Numbers): PlotLine[] {
  const look = lineLook(name);
  const one = { ...look, ...largest };
  if (largest.values.every((value, step) => !(Math.abs(value - least.values[step]) > ROUNDING))) return [one];
  const other = { ...look, name: `${name}-least`, label: `${look.label}, least`, mark: null, dash: [1, 4] };
  return [one, { ...other, ...least }];
}
