import { DEGREES_PER_RADIAN } from "../../controls/format";
import { fieldLayout, fieldRows } from "../../engine";
import type { Scenario } from "../../scenario";
import { type FieldPicture, UNBOUNDED } from "../../scene/field";
import { niceBelow } from "../../scene/geometry";
import type { SceneInput } from "../../scene/input";
import { programOf } from "./field-program";
import { browserIdle, type Field, FieldStore } from "./field-store.svelte";
import { inAngles } from "./next-anchor";

/** The field of the scenario that is shown. */
export const fields = new FieldStore({ layout: fieldLayout, rows: fieldRows }, browserIdle);

const pictures = new WeakMap<Field, FieldPicture>();

/** The field as the scene draws it: the same object for the same field. */
export function picture({
  scenario,
  palette,
}: Pick<SceneInput, "scenario" | "palette">): FieldPicture | null {
  const { field } = fields;
  if (field === null) return null;
  const opacity = Number(palette.css("field-opacity"));
  const known = pictures.get(field);
  if (known?.opacity === opacity) return known;
  const made = pictureOf(field, scenario, opacity);
  pictures.set(field, made);
  return made;
}

export function pictureOf(field: Field, scenario: Scenario, opacity: number): FieldPicture {
  const { values, width, height, corner, u, v } = field;
  const { subject, position_limit, angle_limit } = scenario.field;
  const { factor } = unitOf(scenario);
  const ends = subject === "body" ? scaleOf(values, factor) : endsOf(values, factor);
  const worseThan = inAngles(scenario) ? angle_limit : position_limit;
  const program = subject === "body" ? programOf(field.scenario) : null;
  return { values, width, height, corner, u, v, ...ends, worseThan, opacity, program };
}

/** What the field is shown in, and the factor that takes it there. */
export function unitOf(scenario: Pick<Scenario, "field" | "placement">): { unit: string; factor: number } {
  return inAngles(scenario) ? { unit: "deg", factor: DEGREES_PER_RADIAN } : { unit: "m", factor: 1 };
}

/** So many values tell where the ends of the scale are. */
const MOST_VALUES = 4096;
/** The largest values stand beside a body that loses its last range: they would take all of the scale. */
const SHOWN_SHARE = 0.97;

/** Round ends of the scale around most of the bounds; `factor` takes the values to the unit that is round. */
export function scaleOf(values: Float32Array, factor: number): { low: number; high: number } {
  const stride = Math.ceil(values.length / MOST_VALUES);
  const bounds = values.filter((value, index) => index % stride === 0 && value < UNBOUNDED).sort();
  if (bounds.length === 0) return { low: 0.01 / factor, high: 1 / factor };
  const low = niceBelow(Math.max(bounds[0] * factor, 1e-12));
  const most = bounds[Math.floor(SHOWN_SHARE * (bounds.length - 1))] * factor;
  return { low: low / factor, high: niceAbove(Math.max(most, 2 * low)) / factor };
}

/** The ends differ at least by this factor, or rounding would be coloured. */
const LEAST_RATIO = 1.02;

/** The ends of a scale that takes all its colours for the numbers there are: one more anchor often changes little. */
export function endsOf(values: Float32Array, factor: number): { low: number; high: number } {
  const seen = values.filter((value) => value < UNBOUNDED).sort();
  if (seen.length === 0) return { low: 0.01, high: 1 };
  const least = Math.max(seen[0] * factor, 1e-12);
  const most = Math.max(seen[Math.floor(SHOWN_SHARE * (seen.length - 1))] * factor, LEAST_RATIO * least);
  // The third digit of the larger end, so that numbers beside the scale are short.
  const step = 10 ** (Math.floor(Math.log10(most)) - 2);
  const [low, high] = [Math.floor(least / step), Math.ceil(most / step)];
  return { low: (Math.max(low, 0.1) * step) / factor, high: (high * step) / factor };
}

/** Smallest of 1, 2, 5 times a power of ten that is not below `value`. */
function niceAbove(value: number): number {
  const below = niceBelow(value);
  return below >= value ? below : [2, 2.5, 5].map((factor) => below * factor).find((one) => one >= value)!;
}
