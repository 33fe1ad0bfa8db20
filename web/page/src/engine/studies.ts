/** Studies beside the averages over time: what projections buy, and what drawing anchors anew does. */
import type { Scenario } from "../scenario";
import type { AlongRun, AnchorDraws, BudgetCurves, Deviations } from "../study";
import * as wasm from "../wasm/track/rangelab_track.js";
import { curve } from "./decode";
import { Resident } from "./resident";
import { trackModule } from "./track";

export function budgetBlock(scenario: Scenario, thresholds: Float64Array, firstTrial: number): Float64Array {
  return trackModule.call(() => wasm.budget_block(JSON.stringify(scenario), thresholds, firstTrial));
}

/** What projections cost and give, under way. */
export class BudgetSum {
  readonly #sum: Resident<wasm.BudgetSum>;

  constructor(
    scenario: Scenario,
    private readonly thresholds: Float64Array,
  ) {
    this.#sum = new Resident(trackModule, () => new wasm.BudgetSum(JSON.stringify(scenario), thresholds));
  }

  /** Joins the trials that come next; throws where `block` is not that. */
  push(block: Float64Array): void {
    this.#sum.use((sum) => sum.push(block));
  }

  read(): BudgetCurves {
    return this.#sum.use((sum) => ({
      trials: sum.trials(),
      thresholds: this.thresholds,
      projections: curve(sum.projections()),
      orientation: alongRun(sum.orientation()),
      angle: alongRun(sum.angle()),
    }));
  }

  free(): void {
    this.#sum.free();
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
  readonly #list: Resident<wasm.DrawList>;
  readonly #halfWidth: number;

  constructor(scenario: Scenario) {
    this.#halfWidth = trackModule.call(() => wasm.draws_half_width(JSON.stringify(scenario)));
    this.#list = new Resident(trackModule, () => new wasm.DrawList());
  }

  push(block: Float64Array): void {
    this.#list.use((list) => list.push(block));
  }

  read(): AnchorDraws {
    return this.#list.use((list) => {
      const conditions = list.conditions();
      return {
        trials: list.draws(),
        halfWidth: this.#halfWidth,
        fixedCondition: conditions[0] ?? NaN,
        conditions: conditions.subarray(1),
        bound: deviations(list, 0),
        filter: deviations(list, 1),
        constrained: deviations(list, 2),
      };
    });
  }

  free(): void {
    this.#list.free();
  }
}

function deviations(list: wasm.DrawList, of: number): Deviations {
  const read = (redrawn: boolean) => ({
    angle: list.angles(of, redrawn),
    position: list.positions(of, redrawn),
  });
  return { fixed: read(false), redrawn: read(true) };
}

/** The numbers that these shares (0 to 1) of `numbers` do not exceed; NaN among them is left out. */
export function quantiles(numbers: Float64Array, shares: readonly number[]): number[] {
  return [...trackModule.call(() => wasm.quantiles(numbers, Float64Array.from(shares)))];
}
