import type { Scenario } from "../../scenario";
import type { FieldRows, RowValues } from "../../workers/messages";
import type { PoolListener } from "../../workers/pool";
import type { Field, FieldSource, Refiner } from "./field-source";

export type OpenPool = (listener: PoolListener<FieldRows, RowValues>) => {
  replace(jobs: readonly FieldRows[]): void;
  close(): void;
};

/** Milliseconds without another scenario after which the workers begin: a drag is not worth their while. */
export const REST = 150;
/** Rows that one worker computes at a time: few enough that the next scenario does not wait. */
const ROWS = 32;

/** A finer field that is being put together. */
interface Grid {
  readonly field: Field;
  missing: number;
}

/** What was asked for. */
interface Round {
  readonly scenario: Scenario;
  readonly resolutions: readonly number[];
  readonly found: (field: Field) => void;
  grids: Grid[];
}

/** Finer fields from workers; where these cannot be had, `fallback` computes them from then on. */
export class PoolRefiner implements Refiner {
  #pool: ReturnType<OpenPool> | null = null;
  #lost = false;
  #round: Round | null = null;
  #rest: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly layout: FieldSource["layout"],
    private readonly open: OpenPool,
    private readonly fallback: Refiner,
  ) {}

  refine(scenario: Scenario, resolutions: readonly number[], found: (field: Field) => void): void {
    this.cancel();
    if (this.#lost) return this.fallback.refine(scenario, resolutions, found);
    const round = { scenario, resolutions, found, grids: [] };
    this.#round = round;
    this.#rest = setTimeout(() => this.#begin(round), REST);
  }

  cancel(): void {
    clearTimeout(this.#rest);
    this.fallback.cancel();
    if (this.#round && this.#round.grids.length > 0) this.#pool?.replace([]);
    this.#round = null;
  }

  close(): void {
    this.cancel();
    this.#pool?.close();
  }

  #begin(round: Round): void {
    round.grids = round.resolutions.map((resolution) => this.#grid(round.scenario, resolution));
    try {
      this.#pool ??= this.open({
        done: (job, values) => this.#merge(job, values),
        // A field that is refused stays as coarse as it is.
        failed: (_, refused) => (refused ? this.cancel() : this.#giveUp()),
      });
      this.#pool.replace(round.grids.flatMap(jobsOf));
    } catch {
      this.#giveUp();
    }
  }

  #grid(scenario: Scenario, resolution: number): Grid {
    const layout = this.layout(scenario, resolution);
    const values = new Float32Array(layout.width * layout.height);
    return { field: { ...layout, scenario, resolution, values }, missing: layout.height };
  }

  #merge({ scenario, resolution, first, count }: FieldRows, values: RowValues): void {
    const round = this.#round;
    if (!round || scenario !== round.scenario) return;
    const grid = round.grids.find(({ field }) => field.resolution === resolution);
    // Coarser than one that is there already.
    if (!grid) return;
    grid.field.values.set(values, first * grid.field.width);
    grid.missing -= count;
    if (grid.missing > 0) return;
    round.grids = round.grids.filter(({ field }) => field.resolution > resolution);
    round.found(grid.field);
  }

  #giveUp(): void {
    this.#lost = true;
    this.#pool?.close();
    const round = this.#round;
    if (round) this.refine(round.scenario, unfound(round), round.found);
  }
}

/** The rows of a field in blocks. */
function jobsOf({ field: { scenario, resolution, height } }: Grid): FieldRows[] {
  const blocks = Math.ceil(height / ROWS);
  return Array.from({ length: blocks }, (_, block) => {
    const first = block * ROWS;
    return { scenario, resolution, first, count: Math.min(ROWS, height - first) };
  });
}

function unfound({ grids }: Round): number[] {
  return grids.map(({ field }) => field.resolution);
}
