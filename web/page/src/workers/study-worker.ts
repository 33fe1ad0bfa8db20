/** Runs blocks of trials: an engine of its own, from the module that the page compiled. */
import { EngineTrap, loadEngine, studyBlock } from "../engine";
import type { Answer, Block, Request } from "./messages";

let loaded: Promise<void> = Promise.reject(new Error("A block came before the engine."));
loaded.catch(() => undefined);

self.onmessage = ({ data }: MessageEvent<Request>) => {
  if (data.kind === "load") loaded = loadEngine(data.module);
  else void loaded.then(() => answer(data.block)).catch(fail);
};

function answer({ scenario, firstTrial, trials }: Block): void {
  try {
    const sums = studyBlock(scenario, firstTrial, trials) as Float64Array<ArrayBuffer>;
    post({ kind: "sums", sums }, [sums.buffer]);
  } catch (error) {
    if (!(error instanceof Error) || error instanceof EngineTrap) throw error;
    post({ kind: "refused", sentence: error.message });
  }
}

function post(message: Answer, transfer: Transferable[] = []): void {
  self.postMessage(message, { transfer });
}

/** An engine that trapped cannot go on: the page hears of it as of any crash and takes another worker. */
function fail(error: unknown): void {
  setTimeout(() => {
    throw error;
  });
}
