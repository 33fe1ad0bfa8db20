/** Studies beside the averages over time: what projections buy, and what drawing anchors anew does. */
import type { Scenario } from "../scenario";
import type { AlongRun, AnchorDraws, BudgetCurves, Deviations } from "../study";
import * as wasm from "../wasm/track/rangelab_track.js";
import { curve } from "./decode";
import { trackModule } from "./track";

export function budgetBlock(scenario: Scenario, thresholds: Float64Array, firstTrial: number): Float64Array {
  return trackModule.call(() => wasm.budget_block(JSON.stringify(scenario), thresholds, firstTrial));
}

/** What projections cost and give, under way. */
export class BudgetSum {
  readonly #sum: wasm.BudgetSum;
  readonly #generation = trackModule.generation;

  constructor(
    scenario: Scenario,
    private readonly thresholds: Float64Array,
  ) {
    this.#sum = trackModule.call(() => new wasm.BudgetSum(JSON.stringify(scenario), thresholds));
  }

  /** Joins the trials that come next; throws where `block` is not that. */
  push(block: Float64Array): void {
    trackModule.call(() => this.#sum.push(block));
  }

  read(): BudgetCurves {
    return trackModule.call(() => ({
      trials: this.#sum.trials(),
      thresholds: this.thresholds,
      projections: curve(this.#sum.projections()),
      orientation: alongRun(this.#sum.orientation()),
      angle: alongRun(this.#sum.angle()),
    }));
  }

  free(): void {
    if (this.#generation === trackModule.generation) this.#sum.free();
  }
}

/** The engine writes the curve of the first step, of all and of the last. */
function alongRun(numbers: Float64Array): AlongRun {
  const size = numbers.length / 3;
  const [first, all, last] = [0, 1, 2].map((part) => curve(numbers.subarray(part * size, (part + 1) * size)));
  return { first, all, last };
}

export function drawsBlock(scenario: Scenario, firstDraw: number): Float64Array {
  return trackModule.call(() => wasm.draws_block(JSON.stringify(scenario), firstDraw));
}

/** Anchors drawn so far. */
export class DrawList {
  readonly #list: wasm.DrawList;
  readonly #generation = trackModule.generation;
  readonly #halfWidth: number;

  constructor(scenario: Scenario) {
    this.#halfWidth = trackModule.call(() => wasm.draws_half_width(JSON.stringify(scenario)));
    this.#list = trackModule.call(() => new wasm.DrawList());
  }

  push(block: Float64Array): void {
    trackModule.call(() => this.#list.push(block));
  }

  read(): AnchorDraws {
    return trackModule.call(() => {
      const conditions = this.#list.conditions();
      return {
        trials: this.#list.draws(),
        halfWidth: this.#halfWidth,
        fixedCondition: conditions[0] ?? NaN,
        conditions: conditions.subarray(1),
        bound: this.#deviations(0),
        filter: this.#deviations(1),
        constrained: this.#deviations(2),
      };
    });
  }

  free(): void {
    if (this.#generation === trackModule.generation) this.#list.free();
  }

  #deviations(of: number): Deviations {
    const read = (redrawn: boolean) => ({
      angle: this.#list.angles(of, redrawn),
      position: this.#list.positions(of, redrawn),
    });
    return { fixed: read(false), redrawn: read(true) };
  }
}

/** The numbers that these shares (0 to 1) of `numbers` do not exceed; NaN among them is left out. */
export function quantiles(numbers: Float64Array, shares: readonly number[]): number[] {
  return [...trackModule.call(() => wasm.quantiles(numbers, Float64Array.from(shares)))];
}
