/** The module of the lab Localize: snapshot estimators in one trial, in many, and over a sweep of the noise. */
import type { LocalizationReport } from "../generated/LocalizationReport";
import type { SnapshotRun } from "../generated/SnapshotRun";
import type { RangeNoise, Scenario } from "../scenario";
import * as wasm from "../wasm/localize/rangelab_localize.js";
import url from "../wasm/localize/rangelab_localize_bg.wasm?url";
import { EngineModule } from "./module";
import { Resident } from "./resident";

export const localizeModule = new EngineModule(wasm, url);

/** What the enabled localizers make of the first epoch of a trial. Throws an `Error` with a sentence. */
export function localize(scenario: Scenario, trial: number): SnapshotRun {
  return JSON.parse(localizeModule.call(() => wasm.localize(JSON.stringify(scenario), trial)));
}

/**
 * Errors of the first trials, as seen from the truth of each. Trial by trial, localizer by localizer: 1 where there is a
 * pose, 1 where it mirrors the body, iterations, `Q_hat Q^T` row by row, `t_hat - t` in m; zeros where there is no pose.
 */
export function localizationCloud(scenario: Scenario, trials: number): Float64Array {
  return localizeModule.call(() => wasm.localization_cloud(JSON.stringify(scenario), trials));
}

/** Averages over the first trials at the scenario's own noise, and the bounds: one point. */
export function localizeAtNoise(scenario: Scenario, trials: number): LocalizationReport {
  return JSON.parse(localizeModule.call(() => wasm.localize_at_noise(JSON.stringify(scenario), trials)));
}

/** A sweep's pieces start at multiples of this. */
export function localizationTrialsPerBlock(): number {
  return wasm.localization_trials_per_block();
}

/** Trials at each noise of a sweep. */
export interface SweepTrials {
  readonly scenario: Scenario;
  readonly sweep: readonly RangeNoise[];
  readonly firstTrial: number;
  readonly trials: number;
}

/** Sums over some trials, for `SweepSum.push`; the numbers mean nothing by themselves. */
export function localizationBlock({ scenario, sweep, firstTrial, trials }: SweepTrials): Float64Array {
  const [text, noises] = [JSON.stringify(scenario), JSON.stringify(sweep)];
  return localizeModule.call(() => wasm.localization_block(text, noises, firstTrial, trials));
}

/** A sweep under way: the same bits as the command line's, whoever computed the blocks. */
export class SweepSum {
  readonly #sum: Resident<wasm.LocalizationSum>;

  constructor(scenario: Scenario, sweep: readonly RangeNoise[]) {
    const [text, noises] = [JSON.stringify(scenario), JSON.stringify(sweep)];
    this.#sum = new Resident(localizeModule, () => new wasm.LocalizationSum(text, noises));
  }

  /** Joins the trials that come next; throws where `block` is not that. */
  push(block: Float64Array): void {
    this.#sum.use((sum) => sum.push(block));
  }

  read(): LocalizationReport {
    return JSON.parse(this.#sum.use((sum) => sum.report()));
  }

  free(): void {
    this.#sum.free();
  }
}
