/** The module that the page starts with: presets, documents, runs of the estimators, studies. */
import type { Preset } from "../generated/Preset";
import type { Problem } from "../generated/Problem";
import type { Run } from "../run";
import type { NamedTopology, Scenario } from "../scenario";
import type { StudyCurves } from "../study";
import * as wasm from "../wasm/track/rangelab_track.js";
import url from "../wasm/track/rangelab_track_bg.wasm?url";
import { decodeRun, decodeStudy } from "./decode";
import { EngineModule } from "./module";
import { Resident } from "./resident";

export const trackModule = new EngineModule(wasm, url);

/** One thing that is wrong with a scenario, and its sentence. */
export type Complaint = Problem & { message: string };

/** What never changes is asked for once: it is there even while the engine is broken. */
const constants = new Map<string, unknown>();

function constant<T>(key: string, ask: () => string): T {
  if (!constants.has(key)) constants.set(key, JSON.parse(trackModule.call(ask)));
  return constants.get(key) as T;
}

export function presets(): readonly Preset[] {
  return constant("presets", () => wasm.presets());
}

export function preset(name: string): Scenario {
  return JSON.parse(trackModule.call(() => wasm.preset(name)));
}

/** The bodies that have a name, their two farthest sensors 1 m apart. */
export function topologies(dimension: number): readonly NamedTopology[] {
  return constant(`topologies ${dimension}`, () => wasm.topologies(dimension));
}

export function validate(scenario: unknown): Complaint[] {
  return JSON.parse(trackModule.call(() => wasm.validate(JSON.stringify(scenario))));
}

/** The scenario of a document, everything filled in that it leaves out. Throws an `Error` with a sentence. */
export function complete(document: unknown): Scenario {
  return JSON.parse(trackModule.call(() => wasm.complete(JSON.stringify(document))));
}

/** Simulates trial 0 of the scenario and runs its estimators on it. Throws an `Error` with a sentence. */
export function track(scenario: Scenario): Run {
  return Resident.once(trackModule, () => wasm.track(JSON.stringify(scenario), 0), decodeRun);
}

/** What `probability` of the numbers drawn from the distribution lies between, as much of the rest below as above. */
export function chiSquaredInterval(degreesOfFreedom: number, probability: number): [number, number] {
  const [low, high] = trackModule.call(() => wasm.chi_squared_interval(degreesOfFreedom, probability));
  return [low, high];
}

/** A study's pieces start at multiples of this. */
export function trialsPerBlock(): number {
  return wasm.trials_per_block();
}

/** Sums over some trials, for `StudySum.push`; the numbers mean nothing by themselves. */
export function studyBlock(scenario: Scenario, firstTrial: number, trials: number): Float64Array {
  return trackModule.call(() => wasm.study_block(JSON.stringify(scenario), firstTrial, trials));
}

/** A study under way: the same bits as the command line's, whoever computed the blocks. */
export class StudySum {
  readonly #sum: Resident<wasm.StudySum>;

  constructor(scenario: Scenario) {
    this.#sum = new Resident(trackModule, () => new wasm.StudySum(JSON.stringify(scenario)));
  }

  /** Joins the trials that come next; throws where `block` is not that. */
  push(block: Float64Array): void {
    this.#sum.use((sum) => sum.push(block));
  }

  read(): StudyCurves {
    return this.#sum.use(decodeStudy);
  }

  free(): void {
    this.#sum.free();
  }
}
