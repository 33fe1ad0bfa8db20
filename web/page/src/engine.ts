/**
 * The only door to the WebAssembly modules: estimators and bounds in one, the scene renderer in two builds.
 * What leaves this file are plain objects, typed arrays and errors whose message is a sentence for the student.
 */
import * as estimators from "./wasm/rangelab/rangelab_wasm.js";
import moduleUrl from "./wasm/rangelab/rangelab_wasm_bg.wasm?url";
import type { Scene } from "./wasm/scene-webgpu/rangelab_scene.js";
import { decodeRun, decodeStudy } from "./decode";
import type { Advice } from "./generated/Advice";
import type { Improvement } from "./generated/Improvement";
import type { Preset } from "./generated/Preset";
import type { Problem } from "./generated/Problem";
import type { Exploration } from "./generated/Exploration";
import type { FieldLayout } from "./generated/FieldLayout";
import type { PointBound } from "./generated/PointBound";
import type { Run } from "./run";
import type { NamedTopology, Scenario } from "./scenario";
import type { StudyCurves } from "./study";

export type WasmScene = Scene;
export type WasmRun = estimators.TrackRun;
export type WasmStudy = estimators.StudySum;

/** One thing that is wrong with a scenario, and its sentence. */
export type Complaint = Problem & { message: string };

/** The instance of the engine is lost, after a bug in it; `restartEngine` gives a fresh one. */
export class EngineTrap extends Error {}

const TRAPPED =
  "The engine stopped at an unexpected place and has to be started again. Nothing of the scenario is lost.";

let compiled: WebAssembly.Module | null = null;
/** Counts restarts: an object of an earlier instance must not reach into the memory of this one. */
let generation = 0;

/** Starts the engine: from the page's own address, or from a module that was compiled before and posted here. */
export async function loadEngine(module?: WebAssembly.Module): Promise<void> {
  compiled = module ?? (await compile(moduleUrl));
  await estimators.default({ module_or_path: compiled });
}

/** The compiled module, to post to workers. */
export function engineModule(): WebAssembly.Module {
  if (compiled === null) throw new Error("The engine is not loaded yet.");
  return compiled;
}

/** A fresh instance, after a trap. Studies begun in the old one are lost with it. */
export async function restartEngine(): Promise<void> {
  if (compiled === null) return loadEngine();
  generation += 1;
  estimators.__wbg_reset_state();
}

export function presets(): Preset[] {
  return JSON.parse(guarded(() => estimators.presets()));
}

export function preset(name: string): Scenario {
  return JSON.parse(guarded(() => estimators.preset(name)));
}

/** The bodies that have a name, their two farthest sensors 1 m apart. */
export function topologies(dimension: number): NamedTopology[] {
  return JSON.parse(guarded(() => estimators.topologies(dimension)));
}

export function validate(scenario: unknown): Complaint[] {
  return JSON.parse(guarded(() => estimators.validate(JSON.stringify(scenario))));
}

/** The scenario of a document, everything filled in that it leaves out. Throws an `Error` with a sentence. */
export function complete(document: unknown): Scenario {
  return JSON.parse(guarded(() => estimators.complete(JSON.stringify(document))));
}

/** Simulates trial 0 of the scenario and runs its estimators on it. Throws an `Error` with a sentence. */
export function track(scenario: Scenario): Run {
  const run = guarded(() => estimators.track(JSON.stringify(scenario), 0));
  try {
    return decodeRun(run);
  } finally {
    run.free();
  }
}

/** What one epoch of ranges shows of the pose that the body starts in. Throws an `Error` with a sentence. */
export function explore(scenario: Scenario): Exploration {
  return JSON.parse(guarded(() => estimators.explore(JSON.stringify(scenario))));
}

/** Where the field of the bound lies; `resolution` is the number of cells along its longer edge. */
export function fieldLayout(scenario: Scenario, resolution: number): FieldLayout {
  return JSON.parse(guarded(() => estimators.field_layout(JSON.stringify(scenario), resolution)));
}

/** Some rows of the field, m or rad; 1e30 and above where no bound exists. */
export function fieldRows(
  scenario: Scenario,
  resolution: number,
  firstRow: number,
  rows: number,
): Float32Array {
  return guarded(() => estimators.field_rows(JSON.stringify(scenario), resolution, firstRow, rows));
}

/** The program (WGSL) by which a graphics device computes the field from `fieldParameters`. */
export function fieldProgram(scenario: Scenario): string {
  return guarded(() => estimators.field_program(JSON.stringify(scenario)));
}

/** What the field's program reads; its grid over the same rectangle may have any number of cells. */
export function fieldParameters(scenario: Scenario): Float32Array {
  return guarded(() => estimators.field_parameters(JSON.stringify(scenario)));
}

/** The bounds with the body at a point, D coordinates in m. */
export function fieldProbe(scenario: Scenario, point: readonly number[]): PointBound {
  const at = Float64Array.from(point);
  return JSON.parse(guarded(() => estimators.field_probe(JSON.stringify(scenario), at)));
}

/** The bound on the orientation (rad, NaN where there is none) of the body made so many times larger. */
export function sizeCurve(scenario: Scenario, scales: Float64Array): Float64Array {
  return guarded(() => estimators.size_curve(JSON.stringify(scenario), scales));
}

/** What the anchors are worth to `placement`, and how that changes with the place of each. Throws a sentence. */
export function advise(scenario: Scenario): Advice {
  return JSON.parse(guarded(() => estimators.advise(JSON.stringify(scenario))));
}

/** One search for better places of the anchors; restart 0 starts from where they are. Throws a sentence. */
export function improve(scenario: Scenario, restart: number): Improvement {
  return JSON.parse(guarded(() => estimators.improve(JSON.stringify(scenario), restart)));
}

/** What `probability` of the numbers drawn from the distribution lies between, as much of the rest below as above. */
export function chiSquaredInterval(degreesOfFreedom: number, probability: number): [number, number] {
  const [low, high] = guarded(() => estimators.chi_squared_interval(degreesOfFreedom, probability));
  return [low, high];
}

/** A study's pieces start at multiples of this. */
export function trialsPerBlock(): number {
  return estimators.trials_per_block();
}

/** Sums over some trials, for `StudySum.push`; the numbers mean nothing by themselves. */
export function studyBlock(scenario: Scenario, firstTrial: number, trials: number): Float64Array {
  return guarded(() => estimators.study_block(JSON.stringify(scenario), firstTrial, trials));
}

/** A study under way: the same bits as the command line's, whoever computed the blocks. */
export class StudySum {
  #sum: WasmStudy;
  #generation = generation;

  constructor(scenario: Scenario) {
    this.#sum = guarded(() => new estimators.StudySum(JSON.stringify(scenario)));
  }

  /** Joins the trials that come next; throws where `block` is not that. */
  push(block: Float64Array): void {
    guarded(() => this.#sum.push(block));
  }

  read(): StudyCurves {
    return guarded(() => decodeStudy(this.#sum));
  }

  free(): void {
    if (this.#generation === generation) this.#sum.free();
  }
}

/** Loads the scene module for the backend and starts it on the canvas. Rejects where the backend is not there. */
export async function createWasmScene(
  backend: "webgpu" | "webgl",
  canvas: HTMLCanvasElement,
): Promise<WasmScene> {
  const module =
    backend === "webgpu"
      ? await import("./wasm/scene-webgpu/rangelab_scene.js")
      : await import("./wasm/scene-webgl/rangelab_scene.js");
  await module.default();
  return module.Scene.create(canvas);
}

/** Compiled while it streams in; a server that calls it something else than WebAssembly costs the streaming only. */
async function compile(url: string): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`The engine could not be fetched (${response.status}).`);
  const isWasm = response.headers.get("Content-Type")?.startsWith("application/wasm");
  return isWasm ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

function guarded<T>(call: () => T): T {
  try {
    return call();
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) throw new EngineTrap(TRAPPED, { cause: error });
    if (error instanceof Error) throw error;
    throw new Error(String(error), { cause: error });
  }
}
