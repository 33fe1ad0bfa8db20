/** The instance of a module is lost, after a bug in it; the next call gets a fresh one. */
export class EngineTrap extends Error {}

const TRAPPED =
  "The engine stopped at an unexpected place and has to be started again. Nothing of the scenario is lost.";

/** What wasm-bindgen gives with every module: what starts an instance, and what replaces it by a fresh one. */
interface Glue {
  default(options: { module_or_path: WebAssembly.Module }): Promise<unknown>;
  __wbg_reset_state(): void;
}

/** A WebAssembly module of the engine and its one instance in this thread. */
export class EngineModule {
  /** Counts the instances that trapped: an object of an earlier one must not reach into the memory of the next. */
  generation = 0;
  #broken = false;
  #compiled: WebAssembly.Module | null = null;
  #loading: Promise<void> | null = null;

  constructor(
    private readonly glue: Glue,
    private readonly url: string,
  ) {}

  /**
   * Starts it: from the page's own address, or from a module that was compiled before and posted here. Once it is
   * there nothing more is done; after a failure it can be asked for again.
   */
  load(module?: WebAssembly.Module): Promise<void> {
    this.#loading ??= this.#start(module).catch((error: unknown) => {
      this.#loading = null;
      throw error;
    });
    return this.#loading;
  }

  /** The compiled module, to post to workers. */
  get compiled(): WebAssembly.Module {
    if (this.#compiled === null) throw new Error("The engine is not loaded yet.");
    return this.#compiled;
  }

  /** Calls into the instance, a fresh one after a trap; what goes wrong is an `Error` whose message is a sentence. */
  call<T>(call: () => T): T {
    if (this.#broken) this.#restart();
    try {
      return call();
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError) {
        this.#broken = true;
        this.generation += 1;
        throw new EngineTrap(TRAPPED, { cause: error });
      }
      if (error instanceof Error) throw error;
      throw new Error(String(error), { cause: error });
    }
  }

  #restart(): void {
    this.glue.__wbg_reset_state();
    this.#broken = false;
  }

  async #start(module?: WebAssembly.Module): Promise<void> {
    const compiled = module ?? (await compile(this.url));
    await this.glue.default({ module_or_path: compiled });
    this.#compiled = compiled;
  }
}

/** Compiled while it streams in; a server that calls it something else than WebAssembly costs the streaming only. */
async function compile(url: string): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`The engine could not be fetched (${response.status}).`);
  const isWasm = response.headers.get("Content-Type")?.startsWith("application/wasm");
  return isWasm ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
