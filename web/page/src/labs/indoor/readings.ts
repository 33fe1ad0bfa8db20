import type { IndoorReport } from "../../generated/IndoorReport";
import { runsAt } from "../../run";
import { type Filter, filterOf } from "./filters";
import { levelsOfReport, levelsOfRun } from "./levels";
import { type IndoorRun, stretchAt } from "./run";

/** A row of the table of errors; null where the filter had stopped. */
export interface Reading extends Filter {
  readonly numbers: {
    /** m */
    readonly position: number;
    /** rad */
    readonly angle: number;
    /** Over its degrees of freedom. */
    readonly nees: number;
    /** The largest singular value of R. */
    readonly stretch: number;
  } | null;
  /** Why there is nothing in the row, or what more there is to know. */
  readonly remark: string;
}

/** The errors at a step. */
export function stepReadings(run: IndoorRun, step: number): Reading[] {
  return run.filters.map((filter) => ({
    ...filterOf(filter.name),
    numbers: runsAt(filter, step)
      ? {
          position: filter.positionErrors[step],
          angle: filter.orientationErrors[step],
          nees: filter.nees[step],
          stretch: stretchAt(filter, step),
        }
      : null,
    remark: remarkOf(filter),
  }));
}

/** Root mean squares over the run, and R at its end. */
export function runReadings(run: IndoorRun): Reading[] {
  const levels = levelsOfRun(run);
  return run.filters.map((filter) => ({
    ...filterOf(filter.name),
    numbers: levels.find(({ name }) => name === filter.name) ?? null,
    remark: remarkOf(filter),
  }));
}

/** The same on the average over trials. */
export function studyReadings(report: IndoorReport): Reading[] {
  const levels = levelsOfReport(report);
  return report.filters.map(({ name, summary: { failures } }) => ({
    ...filterOf(name),
    numbers: levels.find((level) => level.name === name) ?? null,
    remark: failures > 0 ? `stopped in ${failures} of ${report.trials} trials` : "",
  }));
}

function remarkOf({ stopped, repairs }: IndoorRun["filters"][number]): string {
  if (stopped) return `stopped at step ${stopped.step + 1}: ${stopped.sentence}`;
  return repairs > 0 ? `covariance repaired ${repairs} times` : "";
}
