import { formatPoint } from "../../../controls/format";
import {
  sensorStep,
  shiftedPlace,
  withoutSensor,
  withSensorAdded,
  withSensorAt,
} from "../../../rigid-body/body-edits";
import type { Scenario } from "../../../scenario";
import { type Direction, orbit } from "../../../scene/camera";
import type { Vec3 } from "../../../scene/geometry";
import type { Session } from "../../../state/session.svelte";
import type { ExploreRun } from "../run";
import { axisOfKey, directionOf, reachOf, type Side } from "./body-view";
import type { Bounds } from "./change";

/** What is held still while a sensor is moved: from where it came, the grid, and how far one sees. */
interface Grab {
  readonly index: number;
  readonly place: readonly number[];
  readonly step: number;
  readonly reach: number;
}

/** The body on the bench: which sensor is chosen, how it is looked at, and what the last change of it was worth. */
export class BodyDesigner {
  /** The next press says where the chosen sensor goes. */
  placing = $state(false);
  #chosen: number | null = $state(null);
  #turned: Direction = $state.raw(directionOf("space"));
  #grab: Grab | null = $state.raw(null);
  /** The bounds before the last change, and the scenario that this change made. */
  #compared: { before: Bounds; scenario: Scenario } | null = $state.raw(null);
  readonly #session: Session<ExploreRun, Scenario>;

  constructor(session: Session<ExploreRun, Scenario>) {
    this.#session = session;
  }

  get sensors(): number[][] {
    return this.#session.scenario.sensors;
  }

  get dimension(): number {
    return this.#session.scenario.dimension;
  }

  get chosen(): number | null {
    return this.#chosen !== null && this.#chosen < this.sensors.length ? this.#chosen : null;
  }

  choose(index: number | null): void {
    this.#chosen = index;
    if (index === null) this.placing = false;
  }

  get direction(): Direction {
    return this.dimension === 2 ? directionOf("plane") : this.#turned;
  }

  look(side: Side | "space"): void {
    this.#turned = directionOf(side);
  }

  turn(yaw: number, pitch: number): void {
    if (this.dimension === 2) return;
    this.#turned = orbit({ ...this.#turned, target: [0, 0, 0], distance: 1 }, yaw, pitch);
  }

  get reach(): number {
    return this.#grab?.reach ?? reachOf(this.sensors);
  }

  /** The bounds before the last change of the body, as long as nothing else has changed since. */
  get before(): Bounds | null {
    return this.#compared?.scenario === this.#session.scenario ? this.#compared.before : null;
  }

  get moving(): boolean {
    return this.#grab !== null;
  }

  /** Takes hold of the chosen sensor: what follows is one edit until `drop`. */
  take(): void {
    const index = this.chosen;
    if (index === null || this.#grab) return;
    this.#remember();
    const place = this.sensors[index];
    this.#grab = { index, place, step: sensorStep(this.sensors), reach: this.reach };
  }

  /** The sensor is now this far from where it was taken. */
  move(shift: Vec3): void {
    if (!this.#grab) return;
    const { index, place, step } = this.#grab;
    this.#preview(index, shiftedPlace(place, shift, step));
  }

  drop(): void {
    if (!this.#grab) return;
    this.#grab = null;
    this.#session.commit();
  }

  takeBack(): void {
    if (!this.#grab) return;
    this.#grab = null;
    this.#session.cancel();
  }

  /** An arrow key moves the chosen sensor by a step of the grid, with Shift by a tenth of it; `drop` ends it. */
  nudge(key: string, fine: boolean): boolean {
    const along = axisOfKey(key, this.direction, this.dimension);
    if (!along || this.chosen === null) return false;
    this.take();
    if (!this.#grab) return false;
    const { index, step } = this.#grab;
    const by = fine ? step / 10 : step;
    const shift = [0, 0, 0].with(along.axis, along.sign * by);
    this.#preview(index, shiftedPlace(this.sensors[index], shift, by));
    return true;
  }

  add(): void {
    if (this.change("Sensor added", withSensorAdded(this.sensors))) this.choose(this.sensors.length - 1);
  }

  remove(): void {
    const index = this.chosen;
    if (index === null || this.#grab) return;
    if (this.change(`Sensor ${index + 1} removed`, withoutSensor(this.sensors, index)))
      this.choose(this.sensors.length > 0 ? Math.min(index, this.sensors.length - 1) : null);
  }

  /** One whole edit of the body. */
  change(what: string, sensors: number[][]): boolean {
    this.#remember();
    const accepted = this.#session.edit(what, { ...this.#session.scenario, sensors });
    this.#changed();
    return accepted;
  }

  #preview(index: number, place: number[]): void {
    const { scenario } = this.#session;
    const what = `Sensor ${index + 1} moved to ${formatPoint(place)} of the body`;
    this.#session.preview(what, { ...scenario, sensors: withSensorAt(scenario.sensors, index, place) });
    this.#changed();
  }

  /** A drag, a held key or an edit begins: its bounds are what later ones are compared with. */
  #remember(): void {
    const { run, scenario } = this.#session;
    this.#compared = run && { before: run.exploration, scenario };
  }

  #changed(): void {
    if (this.#compared) this.#compared = { ...this.#compared, scenario: this.#session.scenario };
  }
}
