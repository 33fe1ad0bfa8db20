import type { Scenario } from "../../scenario";
import type { Field, FieldSource, Refiner } from "./field-source";

/** Runs something when the page has nothing else to do. */
export interface Idle {
  request(task: () => void): number;
  cancel(request: number): void;
  /** Milliseconds. */
  now(): number;
}

/** Milliseconds that the field may take of an idle moment. */
const SLICE = 6;
/** Rows computed between looks at the clock. */
const ROWS = 4;

/** Finer fields in the idle moments of the page's own thread. */
export class IdleRefiner implements Refiner {
  #pending: number | null = null;

  constructor(
    private readonly source: FieldSource,
    private readonly idle: Idle,
  ) {}

  refine(scenario: Scenario, [resolution, ...finer]: readonly number[], found: (field: Field) => void): void {
    this.cancel();
    if (resolution === undefined) return;
    const layout = this.source.layout(scenario, resolution);
    const values = new Float32Array(layout.width * layout.height);
    let row = 0;
    const slice = () => {
      this.#pending = null;
      const end = this.idle.now() + SLICE;
      do {
        const count = Math.min(ROWS, layout.height - row);
        values.set(this.source.rows(scenario, resolution, row, count), row * layout.width);
        row += count;
      } while (row < layout.height && this.idle.now() < end);
      if (row < layout.height) return this.#later(slice);
      found({ ...layout, scenario, resolution, values });
      this.refine(scenario, finer, found);
    };
    this.#later(slice);
  }

  cancel(): void {
    if (this.#pending !== null) this.idle.cancel(this.#pending);
    this.#pending = null;
  }

  close(): void {
    this.cancel();
  }

  #later(task: () => void): void {
    this.#pending = this.idle.request(task);
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
