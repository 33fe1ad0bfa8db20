import type { EngineModule } from "./module";

/** The object was lost with its instance, which broke over something else; whoever needs it makes it anew. */
export class EngineRestarted extends Error {}

/** An object in the memory of a module's instance, such as a run or a study under way. */
export class Resident<T extends { free(): void }> {
  readonly #object: T;
  readonly #generation: number;

  constructor(
    private readonly module: EngineModule,
    make: () => T,
  ) {
    this.#object = module.call(make);
    this.#generation = module.generation;
  }

  /** Whether it went with its instance. */
  get lost(): boolean {
    return this.#generation !== this.module.generation;
  }

  /** Reads or changes it; throws `EngineRestarted` where it is lost. */
  use<R>(work: (object: T) => R): R {
    if (this.lost) throw new EngineRestarted("The engine had to be started again meanwhile.");
    return this.module.call(() => work(this.#object));
  }

  free(): void {
    if (!this.lost) this.#object.free();
  }

  /** What is made of an object that nobody needs afterwards. */
  static once<T extends { free(): void }, R>(module: EngineModule, make: () => T, work: (object: T) => R): R {
    const resident = new Resident(module, make);
    try {
      return resident.use(work);
    } finally {
      resident.free();
    }
  }
}
