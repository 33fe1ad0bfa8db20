import type { FieldLayout } from "../../generated/FieldLayout";
import type { Scenario } from "../../scenario";

/** Computes the field: all of its geometry, or some of its rows. */
export interface FieldSource {
  layout(scenario: Scenario, resolution: number): FieldLayout;
  rows(scenario: Scenario, resolution: number, first: number, count: number): Float32Array;
}

/** Runs something when the page has nothing else to do. */
export interface Idle {
  request(task: () => void): number;
  cancel(request: number): void;
  /** Milliseconds. */
  now(): number;
}

export interface Field extends FieldLayout {
  readonly scenario: Scenario;
  readonly resolution: number;
  readonly values: Float32Array;
}

/** Cells along the longer edge, from what is there at once to what comes while nothing moves. */
const RESOLUTIONS = [16, 32, 64, 128, 256];
const FIRST = 64;
/** Milliseconds that the field may take of a frame, and of an idle moment. */
const AT_ONCE = 8;
const SLICE = 6;
/** Rows computed between looks at the clock. */
const ROWS = 4;

/** The field of a scenario: a coarse one at once, finer ones in idle moments until the next scenario comes. */
export class FieldStore {
  field: Field | null = $state.raw(null);
  readonly #source: FieldSource;
  readonly #idle: Idle;
  #pending: number | null = null;
  #first = FIRST;

  constructor(source: FieldSource, idle: Idle) {
    this.#source = source;
    this.#idle = idle;
  }

  /** Throws what the source throws. */
  show(scenario: Scenario): void {
    this.cancel();
    const resolution = this.#first;
    const start = this.#idle.now();
    const layout = this.#source.layout(scenario, resolution);
    const values = this.#source.rows(scenario, resolution, 0, layout.height);
    this.#first = this.#fitting(resolution, this.#idle.now() - start);
    this.field = { ...layout, scenario, resolution, values };
    this.#refine(
      scenario,
      RESOLUTIONS.filter((finer) => finer > resolution),
    );
  }

  cancel(): void {
    if (this.#pending !== null) this.#idle.cancel(this.#pending);
    this.#pending = null;
  }

  /** The finest that fits, as each has four times the cells of the one before; the first one is fine enough. */
  #fitting(resolution: number, milliseconds: number): number {
    const cost = (other: number) => milliseconds * (other / resolution) ** 2;
    const fitting = RESOLUTIONS.filter((other) => other <= FIRST && cost(other) <= AT_ONCE);
    return fitting.at(-1) ?? RESOLUTIONS[0];
  }

  #refine(scenario: Scenario, [resolution, ...finer]: readonly number[]): void {
    if (resolution === undefined) return;
    const layout = this.#source.layout(scenario, resolution);
    const values = new Float32Array(layout.width * layout.height);
    let row = 0;
    const slice = () => {
      this.#pending = null;
      const end = this.#idle.now() + SLICE;
      do {
        const count = Math.min(ROWS, layout.height - row);
        values.set(this.#source.rows(scenario, resolution, row, count), row * layout.width);
        row += count;
      } while (row < layout.height && this.#idle.now() < end);
      if (row < layout.height) return this.#later(slice);
      this.field = { ...layout, scenario, resolution, values };
      this.#refine(scenario, finer);
    };
    this.#later(slice);
  }

  #later(task: () => void): void {
    this.#pending = this.#idle.request(task);
  }
}

/** The idle moments of a browser; one without them gives a little time between frames. */
export const browserIdle: Idle = {
  request: (task) =>
    typeof requestIdleCallback === "function"
      ? requestIdleCallback(task, { timeout: 500 })
      : window.setTimeout(task, 20),
  cancel: (request) =>
    typeof cancelIdleCallback === "function" ? cancelIdleCallback(request) : clearTimeout(request),
  now: () => performance.now(),
};
