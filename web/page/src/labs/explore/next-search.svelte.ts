import { bestNext } from "../../engine";
import type { NextPlace } from "../../generated/NextPlace";
import type { Scenario } from "../../scenario";
import type { BestNext, Scene } from "../../workers/messages";
import { type PoolListener, WorkerPool } from "../../workers/pool";
import { startNextWorker } from "../../workers/start";

export type OpenPool = (listener: PoolListener<Scene, BestNext>) => {
  replace(jobs: readonly Scene[]): void;
};

/** Milliseconds for which the place of the scene before still stands: in a drag the next one comes within a few. */
export const GRACE = 250;

/** The best place for one more anchor, found in a worker: among many places of the body it takes seconds. */
export class NextSearch {
  /** Null while none is known, and where no place gives a bound. */
  place: NextPlace | null = $state.raw(null);
  searching = $state(false);
  #wanted: Scenario | null = null;
  #pool: ReturnType<OpenPool> | null = null;
  #lost = false;
  #grace: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly open: OpenPool,
    private readonly alone: (scenario: Scenario) => NextPlace | null,
  ) {}

  /** Searches for this scenario and no other; nothing, where its field shows something else. */
  show(scenario: Scenario): void {
    clearTimeout(this.#grace);
    if (scenario.field.subject !== "next_anchor") return this.#forget();
    this.#wanted = scenario;
    this.searching = true;
    this.#grace = setTimeout(() => (this.place = null), GRACE);
    this.#ask(scenario);
  }

  #ask(scenario: Scenario): void {
    if (this.#lost) return this.#found(scenario, this.alone(scenario));
    try {
      this.#pool ??= this.open({
        done: ({ scenario: asked }, { place }) => this.#found(asked, place),
        failed: () => this.#giveUp(),
      });
      this.#pool.replace([{ scenario }]);
    } catch {
      this.#giveUp();
    }
  }

  #found(scenario: Scenario, place: NextPlace | null): void {
    if (scenario !== this.#wanted) return;
    clearTimeout(this.#grace);
    this.place = place;
    this.searching = false;
  }

  /** Without workers the page searches itself, which it then waits for. */
  #giveUp(): void {
    this.#lost = true;
    if (this.#wanted) this.#ask(this.#wanted);
  }

  #forget(): void {
    this.#wanted = null;
    this.place = null;
    this.searching = false;
  }
}

/** The page's one search. */
export const nextSearch = new NextSearch(
  (listener) => new WorkerPool(1, startNextWorker, listener),
  bestNext,
);
