import type { Scenario } from "../../scenario";
import type { Field, FieldSource, Refiner } from "./field-source";

/** Cells along the longer edge, from what is there at once to what comes while nothing moves. */
const RESOLUTIONS = [16, 32, 64, 128, 256];
const FIRST = 64;
/** Milliseconds that the field may take of a frame. */
const AT_ONCE = 8;

/** The field of a scenario: a coarse one at once, finer ones from the refiner until the next scenario comes. */
export class FieldStore {
  field: Field | null = $state.raw(null);
  #first = FIRST;

  constructor(
    private readonly source: FieldSource,
    private readonly refiner: Refiner,
    private readonly now: () => number,
  ) {}

  /** Throws what the source throws. */
  show(scenario: Scenario): void {
    this.refiner.cancel();
    const resolution = this.#first;
    const start = this.now();
    const layout = this.source.layout(scenario, resolution);
    const values = this.source.rows(scenario, resolution, 0, layout.height);
    this.#first = fitting(resolution, this.now() - start);
    this.field = { ...layout, scenario, resolution, values };
    const finer = RESOLUTIONS.filter((other) => other > resolution);
    this.refiner.refine(scenario, finer, (field) => (this.field = field));
  }

  /** Nobody looks at it for now. */
  close(): void {
    this.refiner.close();
  }
}

/** The finest that fits, as each has four times the cells of the one before; the first one is fine enough. */
function fitting(resolution: number, milliseconds: number): number {
  const cost = (other: number) => milliseconds * (other / resolution) ** 2;
  const fit = RESOLUTIONS.filter((other) => other <= FIRST && cost(other) <= AT_ONCE);
  return fit.at(-1) ?? RESOLUTIONS[0];
}
