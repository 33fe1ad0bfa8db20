import { fieldLayout, fieldParameters, fieldProgram } from "../../engine";
import type { FieldLayout } from "../../generated/FieldLayout";
import type { Scenario } from "../../scenario";
import type { FieldProgram } from "../../scene/field";

/** Cells along the longer edge where a graphics device computes them. */
const CELLS = 512;

const texts = new Map<string, string>();
const programs = new WeakMap<Scenario, FieldProgram>();

/** What computes a scenario's field on a graphics device: the same object for the same scenario. */
export function programOf(scenario: Scenario): FieldProgram {
  const known = programs.get(scenario);
  if (known) return known;
  const made = new ScenarioProgram(scenario);
  programs.set(scenario, made);
  return made;
}

/** Worked out when a renderer that can compute asks, so that a drag drawn by another one does not pay for it. */
class ScenarioProgram implements FieldProgram {
  #layout: FieldLayout | null = null;
  #parameters: Float32Array | null = null;

  constructor(private readonly scenario: Scenario) {}

  /** All that the text depends on. */
  get key(): string {
    const { dimension, field } = this.scenario;
    return `${dimension} ${field.form} ${field.quantity}`;
  }

  get text(): string {
    const { key } = this;
    const text = texts.get(key) ?? fieldProgram(this.scenario);
    texts.set(key, text);
    return text;
  }

  get parameters(): Float32Array {
    return (this.#parameters ??= fieldParameters(this.scenario));
  }

  get width(): number {
    return this.#grid.width;
  }

  get height(): number {
    return this.#grid.height;
  }

  get #grid(): FieldLayout {
    return (this.#layout ??= fieldLayout(this.scenario, CELLS));
  }
}
