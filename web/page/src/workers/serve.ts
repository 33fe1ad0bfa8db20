import { type EngineModule, EngineTrap } from "../engine/module";
import type { Answer, Request } from "./messages";

/** Makes this thread a worker that does jobs: with an instance of its own of the module that the page compiled. */
export function serve<Job, Result>(
  engine: EngineModule,
  work: (job: Job) => Result,
  handedOver: (result: Result) => Transferable[] = () => [],
): void {
  let loaded: Promise<void> = Promise.reject(new Error("A job came before the engine."));
  loaded.catch(() => undefined);
  self.onmessage = ({ data }: MessageEvent<Request<Job>>) => {
    if (data.kind === "load") loaded = engine.load(data.module);
    else void loaded.then(() => answer(data.job)).catch(fail);
  };

  function answer(job: Job): void {
    try {
      const result = work(job);
      post({ kind: "done", result }, handedOver(result));
    } catch (error) {
      if (!(error instanceof Error) || error instanceof EngineTrap) throw error;
      post({ kind: "refused", sentence: error.message });
    }
  }

  function post(message: Answer<Result>, transfer: Transferable[] = []): void {
    self.postMessage(message, { transfer });
  }
}

/** An engine that trapped cannot go on: the page hears of it as of any crash and takes another worker. */
function fail(error: unknown): void {
  setTimeout(() => {
    throw error;
  });
}
