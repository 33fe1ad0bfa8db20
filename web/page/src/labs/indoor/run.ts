import { type FilterRun, indoorPreset, runIndoor } from "../../engine";
import type { IndoorScenario } from "../../generated/IndoorScenario";
import type { LabRun } from "../../lab";
import { SHOWN_FIRST } from "./filters";

/** Trial 0 through the filters. */
export interface IndoorRun extends LabRun {
  readonly scenario: IndoorScenario;
  /** 1 where the range was measured: K x M x 3. */
  readonly present: Uint8Array;
  /** 1 where ranges were taken at the end of a step. */
  readonly fixes: Uint8Array;
  readonly filters: readonly FilterRun[];
}

export function runOf(scenario: IndoorScenario): IndoorRun {
  const { times, beacons, ...trial } = runIndoor(scenario, 0);
  return { ...trial, scenario, dimension: 3, steps: times.length, times, anchors: beacons };
}

/** A preset with the filters that tell its lesson; the others are switched on by hand. */
export function presetOf(name: string): IndoorScenario {
  const scenario = indoorPreset(name);
  return { ...scenario, filters: { ...scenario.filters, enabled: [...SHOWN_FIRST] } };
}

/** The largest singular value of a filter's `R` at a step. */
export function stretchAt({ singularValues }: FilterRun, step: number): number {
  return singularValues[3 * step];
}
