import type { FigureOrder } from "../figure";
import type { SceneDocument } from "../family";
import type { KinematicsScenario } from "../generated/KinematicsScenario";
import type { NextPlace } from "../generated/NextPlace";
import type { RangeNoise, Scenario } from "../scenario";

/** Trials that one worker runs at a time. */
export interface Block<S extends SceneDocument = SceneDocument> {
  readonly scenario: S;
  readonly firstTrial: number;
  readonly trials: number;
}

/** Trials that one worker runs at each noise of a sweep. */
export interface SweepBlock extends Block<Scenario> {
  readonly sweep: readonly RangeNoise[];
}

/** Trials that one worker runs at each threshold of the ET-KF. */
export interface BudgetBlock extends Block<Scenario> {
  readonly thresholds: Float64Array;
}

/** Trials that one worker runs at each number of stamps, or at the scenario's own where there is none. */
export interface StampBlock extends Block<KinematicsScenario> {
  readonly counts: Uint32Array;
}

/** What a block of trials adds to a study. */
export type Sums = Float64Array<ArrayBuffer>;

/** One job of a figure, from 0. */
export interface FigureJob {
  readonly order: FigureOrder;
  readonly job: number;
}

/** One search for better places of the anchors. */
export interface Search {
  readonly scenario: Scenario;
  readonly restart: number;
}

/** A scenario of which one thing is asked. */
export interface Scene {
  readonly scenario: Scenario;
}

/** The best place for one more anchor; null where no place gives a bound. */
export interface BestNext {
  readonly place: NextPlace | null;
}

/** Some rows of the field of a scenario. */
export interface FieldRows {
  readonly scenario: Scenario;
  readonly resolution: number;
  readonly first: number;
  readonly count: number;
}

/** The values of those rows. */
export type RowValues = Float32Array<ArrayBuffer>;

export type Request<Job> =
  | { readonly kind: "load"; readonly module: WebAssembly.Module }
  | { readonly kind: "job"; readonly job: Job };

export type Answer<Result> =
  | { readonly kind: "done"; readonly result: Result }
  /** The scenario itself is at fault: another worker would say the same. */
  | { readonly kind: "refused"; readonly sentence: string };
