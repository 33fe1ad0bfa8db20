import type { FieldLayout } from "../../generated/FieldLayout";
import type { Scenario } from "../../scenario";

/** A field of the bound, computed with so many cells along the longer edge. */
export interface Field extends FieldLayout {
  readonly scenario: Scenario;
  readonly resolution: number;
  readonly values: Float32Array;
}

/** Computes the field: all of its geometry, or some of its rows. */
export interface FieldSource {
  layout(scenario: Scenario, resolution: number): FieldLayout;
  rows(scenario: Scenario, resolution: number, first: number, count: number): Float32Array;
}

/** Computes finer fields than those that are there at once. */
export interface Refiner {
  /** Tells each field as it is found, from coarse to fine; what was asked for before is dropped. */
  refine(scenario: Scenario, resolutions: readonly number[], found: (field: Field) => void): void;
  cancel(): void;
  /** Cancels and lets go of what only refining needs; it can be asked again. */
  close(): void;
}
