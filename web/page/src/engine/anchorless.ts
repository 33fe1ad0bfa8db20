/** The module of the lab Anchorless: its documents, one trial through its estimators, bounds, and studies of many. */
import type { GramSpectrum } from "../generated/GramSpectrum";
import type { KinematicsBoundReport } from "../generated/KinematicsBoundReport";
import type { KinematicsName } from "../generated/KinematicsName";
import type { KinematicsPreset } from "../generated/KinematicsPreset";
import type { KinematicsReport } from "../generated/KinematicsReport";
import type { KinematicsScenario } from "../generated/KinematicsScenario";
import * as wasm from "../wasm/anchorless/rangelab_anchorless.js";
import url from "../wasm/anchorless/rangelab_anchorless_bg.wasm?url";
import { EngineModule } from "./module";
import { Resident } from "./resident";
import type { Complaint } from "./track";

export const anchorlessModule = new EngineModule(wasm, url);

/** What one estimator made of one trial: K instants, N nodes, D coordinates, node by node; empty where there is nothing. */
export interface KinematicsFound {
  readonly name: KinematicsName;
  readonly label: string;
  /** Why it gave nothing, in a sentence. */
  readonly failure: string | null;
  /** Root mean squares over the coordinates of Y_0, Y_1, …, m/s^l. */
  readonly coefficient_errors: readonly number[];
  /** Of the entries of B_0, B_1, B_2, m²/s^l. */
  readonly gram_errors: readonly number[];
  /** Below 1 the accelerations drown in noise; null where they are not found from distances. */
  readonly acceleration_margin: number | null;
  readonly iterations: number;
  /** The positions that it found less the truth, after one alignment, m: K x N x D. */
  readonly errors: Float64Array;
  /** The same of Y_0, Y_1 and Y_2, m/s^l: each N x D. */
  readonly coefficientErrors: readonly Float64Array[];
  /** Of one epoch at a time: stamps x N x D, NaN where a distance is missing. */
  readonly snapshotErrors: Float64Array;
  /** Root mean squares over the coordinates with that alignment, m: K. */
  readonly positionErrors: Float64Array;
  /** The same with an alignment at each instant, m: K. */
  readonly alignedPositionErrors: Float64Array;
}

type Bound = Pick<KinematicsBoundReport, "failure" | "coefficients" | "positions" | "aligned_positions">;

/** What no unbiased estimator can beat. */
export interface KinematicsBounds {
  /** From distances alone. */
  readonly distances: Bound;
  /** From distances and accelerometers. */
  readonly accelerometers: Bound;
}

/** One trial. */
export interface KinematicsTrial {
  /** The instants at which the motion is played, s: K. */
  readonly times: Float64Array;
  readonly stamps: Float64Array;
  /** How many distances are missing. */
  readonly missing: number;
  /** The true positions, centred, m: K x N x D. */
  readonly truth: Float64Array;
  readonly estimators: readonly KinematicsFound[];
}

/** The presets never change: they are there even while the engine is broken. */
let known: readonly KinematicsPreset[] | null = null;

export function anchorlessPresets(): readonly KinematicsPreset[] {
  known ??= JSON.parse(anchorlessModule.call(() => wasm.anchorless_presets())) as readonly KinematicsPreset[];
  return known;
}

export function anchorlessPreset(name: string): KinematicsScenario {
  return JSON.parse(anchorlessModule.call(() => wasm.anchorless_preset_scenario(name)));
}

export function validateAnchorless(scenario: unknown): Complaint[] {
  return JSON.parse(anchorlessModule.call(() => wasm.validate_anchorless(JSON.stringify(scenario))));
}

/** The scenario of a document, everything filled in that it leaves out. Throws an `Error` with a sentence. */
export function completeAnchorless(document: unknown): KinematicsScenario {
  return JSON.parse(anchorlessModule.call(() => wasm.complete_anchorless(JSON.stringify(document))));
}

/** Simulates a trial of the scenario and runs its estimators on it. Throws an `Error` with a sentence. */
export function runAnchorless(scenario: KinematicsScenario, trial: number): KinematicsTrial {
  return Resident.once(anchorlessModule, () => wasm.run_anchorless(JSON.stringify(scenario), trial), decode);
}

const DRAWN = [0, 1, 2];

function decode(run: wasm.AnchorlessTrial): KinematicsTrial {
  const told: KinematicsFound[] = JSON.parse(run.estimators());
  return {
    times: run.times(),
    stamps: run.stamps(),
    missing: run.missing(),
    truth: run.truth(),
    estimators: told.map((entry, index) => ({
      ...entry,
      errors: run.errors(index),
      coefficientErrors: DRAWN.map((l) => run.coefficient_error(index, l)),
      snapshotErrors: run.snapshot_errors(index),
      positionErrors: run.position_errors(index),
      alignedPositionErrors: run.aligned_position_errors(index),
    })),
  };
}

/** The eigenvalues of the Gram matrices of a trial. Throws an `Error` with a sentence. */
export function anchorlessSpectrum(scenario: KinematicsScenario, trial: number): GramSpectrum {
  return JSON.parse(anchorlessModule.call(() => wasm.anchorless_spectrum(JSON.stringify(scenario), trial)));
}

type BoundPair = [distances: KinematicsBoundReport, accelerometers: KinematicsBoundReport];

function boundsFrom([distances, accelerometers]: BoundPair): KinematicsBounds {
  return { distances, accelerometers };
}

/** The bounds at each number of stamps, or at the scenario's own where there is none. Throws an `Error` with a sentence. */
function anchorlessBounds(scenario: KinematicsScenario, counts: Uint32Array): KinematicsBounds[] {
  const text = JSON.stringify(scenario);
  const pairs: BoundPair[] = JSON.parse(anchorlessModule.call(() => wasm.anchorless_bounds(text, counts)));
  return pairs.map(boundsFrom);
}

/** The bounds of the scenario asked about last: its report and its covariances are read one after the other. */
let kept: { text: string; bounds: Resident<wasm.AnchorlessBounds> } | null = null;

function boundsOf(scenario: KinematicsScenario): Resident<wasm.AnchorlessBounds> {
  const text = JSON.stringify(scenario);
  if (kept?.text === text && !kept.bounds.lost) return kept.bounds;
  kept?.bounds.free();
  kept = null;
  kept = { text, bounds: new Resident(anchorlessModule, () => new wasm.AnchorlessBounds(text)) };
  return kept.bounds;
}

/** The bounds at the scenario's own stamps. Throws an `Error` with a sentence. */
export function anchorlessOwnBounds(scenario: KinematicsScenario): KinematicsBounds {
  return boundsFrom(JSON.parse(boundsOf(scenario).use((bounds) => bounds.reports())));
}

/** The bound on the covariance of each node's position at a time (s), m²: N x D x D. Throws where there is none. */
export function anchorlessCovariances(
  scenario: KinematicsScenario,
  accelerometers: boolean,
  time: number,
): Float64Array {
  return boundsOf(scenario).use((bounds) => bounds.positions(accelerometers, time));
}

/** The same of the tips of the arrows of the l-th derivative, drawn `factor` (s^l) long. Throws where there is none. */
export function anchorlessTipCovariances(
  scenario: KinematicsScenario,
  accelerometers: boolean,
  l: number,
  factor: number,
): Float64Array {
  return boundsOf(scenario).use((bounds) => bounds.tips(accelerometers, l, factor));
}

/** A study's pieces start at multiples of this. */
export function anchorlessTrialsPerBlock(): number {
  return wasm.anchorless_trials_per_block();
}

/**
 * Sums over one block of trials at each number of stamps, for `AnchorlessSum.push`; they mean nothing by themselves. The
 * first block brings the bounds with it: they take longer than the page could wait for.
 */
export function anchorlessBlock(
  scenario: KinematicsScenario,
  counts: Uint32Array,
  firstTrial: number,
): Float64Array {
  const text = JSON.stringify(scenario);
  const block = anchorlessModule.call(() => wasm.anchorless_block(text, counts, firstTrial));
  const bounds = firstTrial === 0 ? flat(anchorlessBounds(scenario, counts)) : [];
  return Float64Array.of(bounds.length, ...bounds, ...block);
}

const KINDS = ["distances", "accelerometers"] as const;
const CURVES = ["coefficients", "positions", "aligned_positions"] as const;

/** Each curve after its length. Why there is no bound is not among numbers: whoever asks for it asks again. */
function flat(all: readonly KinematicsBounds[]): number[] {
  const curves = all.flatMap((bounds) => KINDS.flatMap((kind) => CURVES.map((curve) => bounds[kind][curve])));
  return curves.flatMap((values) => [values.length, ...values]);
}

function unflat(numbers: Float64Array): KinematicsBounds[] {
  let at = 0;
  const next = () => {
    const [from, length] = [at + 1, numbers[at]];
    at = from + length;
    return [...numbers.subarray(from, at)];
  };
  const curves = () => ({
    failure: null,
    coefficients: next(),
    positions: next(),
    aligned_positions: next(),
  });
  const all: KinematicsBounds[] = [];
  while (at < numbers.length) all.push({ distances: curves(), accelerometers: curves() });
  return all;
}

/** A study under way, at each number of stamps or at the scenario's own: the same bits as the command line's. */
export class AnchorlessSum {
  readonly #sum: Resident<wasm.AnchorlessSum>;
  /** One for each number of stamps, once the first block is there. */
  bounds: readonly KinematicsBounds[] = [];

  constructor(scenario: KinematicsScenario, counts: Uint32Array) {
    this.#sum = new Resident(
      anchorlessModule,
      () => new wasm.AnchorlessSum(JSON.stringify(scenario), counts),
    );
  }

  /** Joins the trials that come next; throws where `block` is not that. */
  push(block: Float64Array): void {
    const [length] = block;
    if (length > 0) this.bounds = unflat(block.subarray(1, 1 + length));
    this.#sum.use((sum) => sum.push(block.subarray(1 + length)));
  }

  /** One report for each number of stamps. */
  read(): KinematicsReport[] {
    return JSON.parse(this.#sum.use((sum) => sum.reports()));
  }

  free(): void {
    this.#sum.free();
  }
}
