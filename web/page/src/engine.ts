/**
 * The only door to the WebAssembly modules: estimators and bounds in one, the scene renderer in two builds.
 * What leaves this file are plain objects, typed arrays and errors whose message is a sentence for the student.
 */
import initEstimators, * as estimators from "./wasm/rangelab/rangelab_wasm.js";
import type { Scene } from "./wasm/scene-webgpu/rangelab_scene.js";
import type { Preset } from "./generated/Preset";
import type { Problem } from "./generated/Problem";
import type { BoundRun, EstimatorRun, Run } from "./run";
import type { NamedTopology, Scenario } from "./scenario";

export type WasmScene = Scene;

/** One thing that is wrong with a scenario, and its sentence. */
export type Complaint = Problem & { message: string };

const TRAPPED =
  "The engine stopped at an unexpected place and cannot go on: reload the page. The scenario is kept in the address.";

export async function loadEngine(): Promise<void> {
  await initEstimators();
}

export function presets(): Preset[] {
  return JSON.parse(estimators.presets());
}

export function preset(name: string): Scenario {
  return JSON.parse(estimators.preset(name));
}

/** The bodies that have a name, their two farthest sensors 1 m apart. */
export function topologies(dimension: number): NamedTopology[] {
  return JSON.parse(estimators.topologies(dimension));
}

export function validate(scenario: unknown): Complaint[] {
  return JSON.parse(guarded(() => estimators.validate(JSON.stringify(scenario))));
}

/** Simulates trial 0 of the scenario and runs its estimators on it. Throws an `Error` with a sentence. */
export function track(scenario: Scenario): Run {
  const run = guarded(() => estimators.track(JSON.stringify(scenario), 0));
  try {
    return decode(run);
  } finally {
    run.free();
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

function guarded<T>(call: () => T): T {
  try {
    return call();
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) throw new Error(TRAPPED, { cause: error });
    if (error instanceof Error) throw error;
    throw new Error(String(error), { cause: error });
  }
}

function decode(run: estimators.TrackRun): Run {
  const dimension = run.dimension();
  const names: { name: string; label: string }[] = JSON.parse(run.estimators());
  const bounds: { name: string; label: string }[] = JSON.parse(run.bounds());
  return {
    dimension,
    steps: run.steps(),
    times: run.times(),
    anchors: rows(run.anchors(), dimension),
    truth: { orientations: run.truth_orientations(), positions: run.truth_positions() },
    estimators: names.map((entry, index) => decodeEstimator(run, entry, index)),
    bounds: bounds.map((entry, index) => decodeBound(run, entry, index)),
  };
}

function decodeEstimator(
  run: estimators.TrackRun,
  entry: { name: string; label: string },
  index: number,
): EstimatorRun {
  const step = run.failed_at(index);
  return {
    ...entry,
    orientations: run.orientations(index),
    positions: run.positions(index),
    orientationErrors: run.orientation_errors(index),
    positionErrors: run.position_errors(index),
    defects: run.defects(index),
    events: run.events(index),
    positionCovariances: run.position_covariances(index),
    stopped: step < 0 ? null : { step, sentence: run.failure(index) },
  };
}

function decodeBound(
  run: estimators.TrackRun,
  entry: { name: string; label: string },
  index: number,
): BoundRun {
  return {
    ...entry,
    orientation: run.orientation_bounds(index),
    position: run.position_bounds(index),
    positionCovariances: run.position_bound_covariances(index),
  };
}

function rows(values: Float64Array, width: number): number[][] {
  return Array.from({ length: values.length / width }, (_, row) => [
    ...values.subarray(row * width, (row + 1) * width),
  ]);
}
