/** The module of the lab Explore: bounds at a pose and over a plane, better places for the anchors. */
import type { Advice } from "../generated/Advice";
import type { Exploration } from "../generated/Exploration";
import type { FieldLayout } from "../generated/FieldLayout";
import type { Improvement } from "../generated/Improvement";
import type { NextPlace } from "../generated/NextPlace";
import type { PointBound } from "../generated/PointBound";
import type { Scenario } from "../scenario";
import * as wasm from "../wasm/explore/rangelab_explore.js";
import url from "../wasm/explore/rangelab_explore_bg.wasm?url";
import { EngineModule } from "./module";

export const exploreModule = new EngineModule(wasm, url);

/** What one epoch of ranges shows of the pose that the body starts in. Throws an `Error` with a sentence. */
export function explore(scenario: Scenario): Exploration {
  return JSON.parse(exploreModule.call(() => wasm.explore(JSON.stringify(scenario))));
}

/** Where the field of the bound lies; `resolution` is the number of cells along its longer edge. */
export function fieldLayout(scenario: Scenario, resolution: number): FieldLayout {
  return JSON.parse(exploreModule.call(() => wasm.field_layout(JSON.stringify(scenario), resolution)));
}

/** Some rows of the field, m or rad; 1e30 and above where no bound exists. */
export function fieldRows(
  scenario: Scenario,
  resolution: number,
  firstRow: number,
  rows: number,
): Float32Array {
  return exploreModule.call(() => wasm.field_rows(JSON.stringify(scenario), resolution, firstRow, rows));
}

/** The program (WGSL) by which a graphics device computes the body's field from `fieldParameters`. */
export function fieldProgram(scenario: Scenario): string {
  return exploreModule.call(() => wasm.field_program(JSON.stringify(scenario)));
}

/** What the field's program reads; its grid over the same rectangle may have any number of cells. */
export function fieldParameters(scenario: Scenario): Float32Array {
  return exploreModule.call(() => wasm.field_parameters(JSON.stringify(scenario)));
}

/** The bounds with the body at a point, D coordinates in m. */
export function fieldProbe(scenario: Scenario, point: readonly number[]): PointBound {
  const at = Float64Array.from(point);
  return JSON.parse(exploreModule.call(() => wasm.field_probe(JSON.stringify(scenario), at)));
}

/** The bound on the orientation (rad, NaN where there is none) of the body made so many times larger. */
export function sizeCurve(scenario: Scenario, scales: Float64Array): Float64Array {
  return exploreModule.call(() => wasm.size_curve(JSON.stringify(scenario), scales));
}

/** Where the sensors sit on the body in the first trials, m: trial by trial, sensor by sensor, D numbers each. */
export function mountingCloud(scenario: Scenario, trials: number): Float64Array {
  return exploreModule.call(() => wasm.mounting_cloud(JSON.stringify(scenario), trials));
}

/** What one more anchor would be worth at a point, D coordinates in m. Throws a sentence. */
export function nextAt(scenario: Scenario, point: readonly number[]): NextPlace {
  const at = Float64Array.from(point);
  return JSON.parse(exploreModule.call(() => wasm.next_at(JSON.stringify(scenario), at)));
}

/** Where in the plane of the field one more anchor helps most; null where no place gives a bound. Throws a sentence. */
export function bestNext(scenario: Scenario): NextPlace | null {
  return JSON.parse(exploreModule.call(() => wasm.best_next(JSON.stringify(scenario))));
}

/** What the anchors are worth to `placement`, and how that changes with the place of each. Throws a sentence. */
export function advise(scenario: Scenario): Advice {
  return JSON.parse(exploreModule.call(() => wasm.advise(JSON.stringify(scenario))));
}

/** One search for better places of the anchors; restart 0 starts from where they are. Throws a sentence. */
export function improve(scenario: Scenario, restart: number): Improvement {
  return JSON.parse(exploreModule.call(() => wasm.improve(JSON.stringify(scenario), restart)));
}
