import {
  anchorlessModule,
  type EngineModule,
  exploreModule,
  figuresModule,
  indoorModule,
  localizeModule,
  trackModule,
} from "../engine";
import type { Improvement } from "../generated/Improvement";
import type { BestNext, Block, FieldRows, FigureJob, RowValues, Scene, Search, Sums } from "./messages";
import type { PoolWorker } from "./pool";

/** The first picture has this many blocks: more workers would have nothing to do. */
const MOST_WORKERS = 10;

/** One processor is left to the page itself. */
export function workerCount(): number {
  return Math.min(MOST_WORKERS, Math.max(1, navigator.hardwareConcurrency - 1));
}

export function startStudyWorker(): PoolWorker<Block, Sums> {
  return loaded(
    new Worker(new URL("./study-worker.ts", import.meta.url), { type: "module", name: "study" }),
    trackModule,
  );
}

export function startFigureWorker(): PoolWorker<FigureJob, Sums> {
  return loaded(
    new Worker(new URL("./figure-worker.ts", import.meta.url), { type: "module", name: "figure" }),
    figuresModule,
  );
}

export function startSweepWorker(): PoolWorker<Block, Sums> {
  return loaded(
    new Worker(new URL("./sweep-worker.ts", import.meta.url), { type: "module", name: "sweep" }),
    localizeModule,
  );
}

export function startIndoorWorker(): PoolWorker<Block, Sums> {
  return loaded(
    new Worker(new URL("./indoor-worker.ts", import.meta.url), { type: "module", name: "indoor" }),
    indoorModule,
  );
}

export function startAnchorlessWorker(): PoolWorker<Block, Sums> {
  return loaded(
    new Worker(new URL("./anchorless-worker.ts", import.meta.url), { type: "module", name: "anchorless" }),
    anchorlessModule,
  );
}

export function startBudgetWorker(): PoolWorker<Block, Sums> {
  return loaded(
    new Worker(new URL("./budget-worker.ts", import.meta.url), { type: "module", name: "budget" }),
    trackModule,
  );
}

export function startDrawsWorker(): PoolWorker<Block, Sums> {
  return loaded(
    new Worker(new URL("./draws-worker.ts", import.meta.url), { type: "module", name: "draws" }),
    trackModule,
  );
}

export function startPlaceWorker(): PoolWorker<Search, Improvement> {
  return loaded(
    new Worker(new URL("./place-worker.ts", import.meta.url), { type: "module", name: "place" }),
    exploreModule,
  );
}

export function startFieldWorker(): PoolWorker<FieldRows, RowValues> {
  const worker = new Worker(new URL("./field-worker.ts", import.meta.url), { type: "module", name: "field" });
  return loaded(worker, exploreModule);
}

export function startNextWorker(): PoolWorker<Scene, BestNext> {
  const worker = new Worker(new URL("./next-worker.ts", import.meta.url), { type: "module", name: "next" });
  return loaded(worker, exploreModule);
}

function loaded(worker: Worker, engine: EngineModule): Worker {
  worker.postMessage({ kind: "load", module: engine.compiled });
  return worker;
}
