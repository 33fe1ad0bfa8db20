import { roundTo } from "../state/edit";
import { sizeOf } from "./topologies";

/** Edits of a body as pure functions: the old sensors stay where they were. */

export type Sensors = readonly (readonly number[])[];

/** One more sensor, beside the last one, so that it is seen. */
export function withSensorAdded(sensors: Sensors): number[][] {
  const [last] = sensors.slice(-1);
  const size = sizeOf(sensors);
  const step = size > 0 ? size / 2 : 0.1;
  return copied([...sensors, last.with(0, Number((last[0] + step).toPrecision(3)))]);
}

export function withoutSensor(sensors: Sensors, index: number): number[][] {
  return copied(sensors.toSpliced(index, 1));
}

export function withSensorAt(sensors: Sensors, index: number, place: readonly number[]): number[][] {
  return copied(sensors.with(index, place));
}

/** The place moved by `shift`: coordinates that move are rounded to `step`, the others stay to the last digit. */
export function shiftedPlace(place: readonly number[], shift: readonly number[], step: number): number[] {
  return place.map((value, axis) =>
    Math.abs(shift[axis]) < 1e-6 * step ? value : roundTo(value + shift[axis], step),
  );
}

/** A power of ten, at most a twentieth of the body: what sensors are dragged by. */
export function sensorStep(sensors: Sensors): number {
  return 10 ** Math.floor(Math.log10((sizeOf(sensors) || 0.2) / 20));
}

function copied(sensors: Sensors): number[][] {
  return sensors.map((sensor) => [...sensor]);
}
