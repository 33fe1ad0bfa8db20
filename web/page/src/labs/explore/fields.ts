import type { LabRun } from "../../lab";
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
import { inAngles } from "./next-anchor";
import { PoolRefiner } from "./pool-refiner";
import { type Ends, endsOf, scaleOf, SteadyScale } from "./scale";

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
}: Pick<SceneInput<LabRun, Scenario>, "scenario" | "palette">): FieldPicture | null {
  const { field } = fields;
  if (field === null) return null;
  const opacity = Number(palette.css("field-opacity"));
  const known = pictures.get(field);
  if (known?.opacity === opacity) return known;
  const ends = scale.ends(kindOf(field.scenario), field.values, freshEnds(field.scenario));
  const made = pictureOf(field, scenario, ends, opacity);
  pictures.set(field, made);
  return made;
}

export function pictureOf(field: Field, scenario: Scenario, ends: Ends, opacity: number): FieldPicture {
  const { values, width, height, corner, u, v } = field;
  const { subject, position_limit, angle_limit } = scenario.field;
  const worseThan = inAngles(scenario) ? angle_limit : position_limit;
  const program = subject === "body" ? programOf(field.scenario) : null;
  return { values, width, height, corner, u, v, ...ends, worseThan, opacity, program };
}

/** The ends of a scale for these values and no others. */
export function freshEnds(scenario: Scenario): (values: Float32Array) => Ends {
  const { factor } = unitOf(scenario);
  const ends = scenario.field.subject === "body" ? scaleOf : endsOf;
  return (values) => ends(values, factor);
}

/** What has a scale in common: numbers of one meaning in one scene. */
function kindOf({ name, field, placement }: Scenario): string {
  return [name, field.subject, field.form, field.quantity, placement.target].join();
}

/** What the field is shown in, and the factor that takes it there. */
export function unitOf(scenario: Pick<Scenario, "field" | "placement">): { unit: string; factor: number } {
  return inAngles(scenario) ? { unit: "deg", factor: DEGREES_PER_RADIAN } : { unit: "m", factor: 1 };
}
