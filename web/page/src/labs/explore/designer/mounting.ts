import type { Scenario } from "../../../scenario";

/** Where the sensors really sit in trials 0 to `trials` - 1: trial by trial, sensor by sensor, D numbers each, m. */
export type MountingCloud = (scenario: Scenario, trials: number) => Float64Array;

export const CLOUD_TRIALS = 100;
