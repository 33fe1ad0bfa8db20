import { DEGREES_PER_RADIAN } from "../../controls/format";
import { fieldLayout, fieldRows } from "../../engine";
import type { Scenario } from "../../scenario";
import type { FieldPicture } from "../../scene/field";
import type { SceneInput } from "../../scene/input";
import { WorkerPool } from "../../workers/pool";
import { startFieldWorker, workerCount } from "../../workers/start";
import { programOf } from "./field-program";
import type { Field } from "./field-source";
import { FieldStore } from "./field-store.svelte";
import { browserIdle, IdleRefiner } from "./idle-refiner";
import { PoolRefiner } from "./pool-refiner";
import { type Ends, SteadyScale } from "./scale";

const source = { layout: fieldLayout, rows: fieldRows };
const refiner = new PoolRefiner(
  fieldLayout,
  (listener) => new WorkerPool(workerCount(), startFieldWorker, listener),
  new IdleRefiner(source, browserIdle),
);

/** The field of the scenario that is shown. */
export const fields = new FieldStore(source, refiner, () => performance.now());

const pictures = new WeakMap<Field, FieldPicture>();
const scale = new SteadyScale();

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
  const { quantity, form } = field.scenario.field;
  const kind = `${field.scenario.name} ${quantity} ${form}`;
  const ends = scale.ends(kind, field.values, unitOf(quantity).factor);
  const made = pictureOf(field, scenario.field, ends, opacity);
  pictures.set(field, made);
  return made;
}

function pictureOf(field: Field, settings: Scenario["field"], ends: Ends, opacity: number): FieldPicture {
  const { values, width, height, corner, u, v } = field;
  const { quantity, position_limit, angle_limit } = settings;
  const worseThan = quantity === "position" ? position_limit : angle_limit;
  const program = programOf(field.scenario);
  return { values, width, height, corner, u, v, ...ends, worseThan, opacity, program };
}

/** What a bound is shown in, and the factor that takes it there. */
export function unitOf(quantity: Scenario["field"]["quantity"]): { unit: string; factor: number } {
  return quantity === "position" ? { unit: "m", factor: 1 } : { unit: "deg", factor: DEGREES_PER_RADIAN };
}
