/** The module of the papers' figures, computed in numbered jobs. */
import type { FigureOrder, FigurePicture } from "../figure";
import type { Figure } from "../generated/Figure";
import * as wasm from "../wasm/figures/rangelab_figures.js";
import url from "../wasm/figures/rangelab_figures_bg.wasm?url";
import { EngineModule } from "./module";
import { Resident } from "./resident";

export const figuresModule = new EngineModule(wasm, url);

/** Every figure there is. */
export function figures(): readonly Figure[] {
  return JSON.parse(figuresModule.call(() => wasm.figures()));
}

/** The seed of a figure where none is asked for. */
export function figureSeed(): number {
  return figuresModule.call(() => wasm.figure_seed());
}

/** How many jobs there are. Throws a sentence where the figure cannot have such trials or seed. */
export function figureJobs({ name, trials, seed }: FigureOrder): number {
  return figuresModule.call(() => wasm.figure_jobs(name, trials, seed));
}

/** Sums of one job, for `FigureSum.push`; the numbers mean nothing by themselves. */
export function figureBlock({ name, trials, seed }: FigureOrder, job: number): Float64Array {
  return figuresModule.call(() => wasm.figure_block(name, trials, seed, job));
}

/** A figure under way: the same bits as the command line's, whoever computed the jobs. */
export class FigureSum {
  readonly #sum: Resident<wasm.FigureSum>;

  constructor({ name, trials, seed }: FigureOrder) {
    this.#sum = new Resident(figuresModule, () => new wasm.FigureSum(name, trials, seed));
  }

  /** Joins the job that comes next; throws where `block` is not that. */
  push(block: Float64Array): void {
    this.#sum.use((sum) => sum.push(block));
  }

  read(): FigurePicture {
    const json = this.#sum.use((sum) => sum.report());
    return { report: JSON.parse(json), json };
  }

  /** The text of the command line's CSV file. */
  csv(): string {
    return this.#sum.use((sum) => sum.csv());
  }

  free(): void {
    this.#sum.free();
  }
}
