import { fieldLayout, fieldParameters, fieldProgram } from "../../engine";
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
  const { width, height } = fieldLayout(scenario, CELLS);
  const key = keyOf(scenario);
  const made = { key, text: textOf(key, scenario), parameters: fieldParameters(scenario), width, height };
  programs.set(scenario, made);
  return made;
}

/** All that the text depends on. */
function keyOf({ dimension, field }: Scenario): string {
  return `${dimension} ${field.form} ${field.quantity}`;
}

function textOf(key: string, scenario: Scenario): string {
  const text = texts.get(key) ?? fieldProgram(scenario);
  texts.set(key, text);
  return text;
}
