/** The module of the lab Indoor: its documents, one trial through its filters, and studies of many. */
import type { FilterName } from "../generated/FilterName";
import type { IndoorPreset } from "../generated/IndoorPreset";
import type { IndoorReport } from "../generated/IndoorReport";
import type { IndoorScenario } from "../generated/IndoorScenario";
import type { PoseTrack } from "../run";
import * as wasm from "../wasm/indoor/rangelab_indoor.js";
import url from "../wasm/indoor/rangelab_indoor_bg.wasm?url";
import { rows } from "./decode";
import { EngineModule } from "./module";
import { Resident } from "./resident";
import type { Complaint } from "./track";

export const indoorModule = new EngineModule(wasm, url);

/** What one filter made of one trial: typed arrays, K steps, matrices row by row; NaN where there is no number. */
export interface FilterRun extends PoseTrack {
  readonly name: FilterName;
  readonly label: string;
  /** Geodesic angle, rad. */
  readonly orientationErrors: Float64Array;
  /** Metres. */
  readonly positionErrors: Float64Array;
  /** Normalized estimation errors squared over their 9 degrees of freedom. */
  readonly nees: Float64Array;
  /** Over the steps: root mean square errors (m, rad), and the mean NEES over its degrees of freedom. */
  readonly overall: { readonly position: number; readonly angle: number; readonly nees: number };
  /** K x 3, decreasing; all 1 where `R` is a rotation. */
  readonly singularValues: Float64Array;
  /** K x 3 x 3, square metres. */
  readonly positionCovariances: Float64Array;
  /** Of the error's rotation vector in the world frame: K x 3 x 3, rad^2. */
  readonly rotationCovariances: Float64Array;
  /** How many times the covariance was replaced by the nearest positive definite one. */
  readonly repairs: number;
  /** The step at which the filter stopped, or null. */
  readonly stopped: { step: number; sentence: string } | null;
}

/** One trial: M beacons, three transmitters. */
export interface IndoorTrial {
  /** Seconds, one a step. */
  readonly times: Float64Array;
  readonly beacons: number[][];
  /** 1 where the range was measured: K x M x 3. */
  readonly present: Uint8Array;
  /** 1 where ranges were taken at the end of a step. */
  readonly fixes: Uint8Array;
  readonly truth: PoseTrack;
  readonly filters: readonly FilterRun[];
}

/** The presets never change: they are there even while the engine is broken. */
let known: readonly IndoorPreset[] | null = null;

export function indoorPresets(): readonly IndoorPreset[] {
  known ??= JSON.parse(indoorModule.call(() => wasm.indoor_presets())) as readonly IndoorPreset[];
  return known;
}

export function indoorPreset(name: string): IndoorScenario {
  return JSON.parse(indoorModule.call(() => wasm.indoor_preset_scenario(name)));
}

export function validateIndoor(scenario: unknown): Complaint[] {
  return JSON.parse(indoorModule.call(() => wasm.validate_indoor(JSON.stringify(scenario))));
}

/** The scenario of a document, everything filled in that it leaves out. Throws an `Error` with a sentence. */
export function completeIndoor(document: unknown): IndoorScenario {
  return JSON.parse(indoorModule.call(() => wasm.complete_indoor(JSON.stringify(document))));
}

/** Simulates a trial of the scenario and runs its filters on it. Throws an `Error` with a sentence. */
export function runIndoor(scenario: IndoorScenario, trial: number): IndoorTrial {
  return Resident.once(indoorModule, () => wasm.run_indoor(JSON.stringify(scenario), trial), decode);
}

function decode(run: wasm.IndoorTrial): IndoorTrial {
  const filters: Pick<FilterRun, "name" | "label">[] = JSON.parse(run.filters());
  return {
    times: run.times(),
    beacons: rows(run.beacons(), 3),
    present: run.present(),
    fixes: run.fixes(),
    truth: { orientations: run.truth_orientations(), positions: run.truth_positions() },
    filters: filters.map((entry, index) => decodeFilter(run, entry, index)),
  };
}

function decodeFilter(
  run: wasm.IndoorTrial,
  entry: Pick<FilterRun, "name" | "label">,
  index: number,
): FilterRun {
  const step = run.failed_at(index);
  return {
    ...entry,
    orientations: run.orientations(index),
    positions: run.positions(index),
    orientationErrors: run.orientation_errors(index),
    positionErrors: run.position_errors(index),
    nees: run.nees(index),
    overall: {
      position: run.rms_position_error(index),
      angle: run.rms_angle_error(index),
      nees: run.mean_nees(index),
    },
    singularValues: run.singular_values(index),
    positionCovariances: run.position_covariances(index),
    rotationCovariances: run.rotation_covariances(index),
    repairs: run.repairs(index),
    stopped: step < 0 ? null : { step, sentence: run.failure(index) },
  };
}

/** A study's pieces start at multiples of this. */
export function indoorTrialsPerBlock(): number {
  return wasm.indoor_trials_per_block();
}

/** Sums over one block of trials, for `IndoorSum.push`; the numbers mean nothing by themselves. */
export function indoorBlock(scenario: IndoorScenario, firstTrial: number): Float64Array {
  return indoorModule.call(() => wasm.indoor_block(JSON.stringify(scenario), firstTrial));
}

/** A study under way: the same bits as the command line's, whoever computed the blocks. */
export class IndoorSum {
  readonly #sum: Resident<wasm.IndoorSum>;

  constructor(scenario: IndoorScenario) {
    this.#sum = new Resident(indoorModule, () => new wasm.IndoorSum(JSON.stringify(scenario)));
  }

  /** Joins the trials that come next; throws where `block` is not that. */
  push(block: Float64Array): void {
    this.#sum.use((sum) => sum.push(block));
  }

  read(): IndoorReport {
    return JSON.parse(this.#sum.use((sum) => sum.report()));
  }

  free(): void {
    this.#sum.free();
  }
}
