import type { IndoorReport } from "../../generated/IndoorReport";
import { filterOf } from "./filters";
import type { Level } from "./lessons";
import { type IndoorRun, stretchAt } from "./run";

/** Of one run; filters that stopped are left out. */
export function levelsOfRun(run: IndoorRun): Level[] {
  return run.filters
    .filter(({ stopped }) => stopped === null)
    .map((filter) => ({
      name: filter.name,
      label: filterOf(filter.name).label,
      ...filter.overall,
      stretch: stretchAt(filter, run.steps - 1),
    }));
}

/** On the average over trials; filters that reached no end are left out. */
export function levelsOfReport({ filters }: IndoorReport): Level[] {
  return filters
    .filter(({ summary }) => summary.trials > 0)
    .map(({ name, summary }) => ({
      name,
      label: filterOf(name).label,
      position: summary.position.value,
      angle: summary.angle.value,
      stretch: summary.steps.at(-1)?.largest_singular_value.value ?? 1,
      nees: summary.nees.value,
    }));
}
