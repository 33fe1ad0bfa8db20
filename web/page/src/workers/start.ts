import { engineModule } from "../engine";
import type { StudyWorker } from "./pool";

/** The first picture has this many blocks: more workers would have nothing to do. */
const MOST_WORKERS = 10;

/** One processor is left to the page itself. */
export function workerCount(): number {
  return Math.min(MOST_WORKERS, Math.max(1, navigator.hardwareConcurrency - 1));
}

export function startWorker(): StudyWorker {
  const worker = new Worker(new URL("./study-worker.ts", import.meta.url), { type: "module", name: "study" });
  worker.postMessage({ kind: "load", module: engineModule() });
  return worker;
}
