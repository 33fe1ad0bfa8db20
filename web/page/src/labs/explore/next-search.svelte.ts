import { bestNext } from "../../engine";
import type { NextPlace } from "../../generated/NextPlace";
import type { Scenario } from "../../scenario";
import type { BestNext, Scene } from "../../workers/messages";
import { type PoolListener, WorkerPool } from "../../workers/pool";
import { startNextWorker } from "../../workers/start";

export type OpenPool = (listener: PoolListener<Scene, BestNext>) => {
  replace(jobs: readonly Scene[]): void;
  close(): void;
};

/** Milliseconds for which the place of the scene before still stands: in a drag the next one comes within a few. */
export const GRACE = 250;
/** Milliseconds after which a search that nobody wants any more is not waited for. */
export const PATIENCE = 250;

/** The best place for one more anchor, found in a worker: among many places of the body it takes seconds. */
export class NextSearch {
  /** Null while none is known, and where no place gives a bound. */
  place: NextPlace | null = $state.raw(null);
  searching = $state(false);
  #wanted: Scenario | null = null;
  #pool: ReturnType<OpenPool> | null = null;
  #lost = false;
  #grace: ReturnType<typeof setTimeout> | undefined;
  /** When the search under way began; null where none is. */
  #began: number | null = null;

  constructor(
    private readonly open: OpenPool,
    private readonly alone: (scenario: Scenario) => NextPlace | null,
  ) {}

  /** Searches for this scenario and no other; nothing, where its field shows something else. */
  show(scenario: Scenario): void {
    if (scenario.field.subject !== "next_anchor") return this.close();
    clearTimeout(this.#grace);
    this.#wanted = scenario;
    this.searching = true;
    this.#grace = setTimeout(() => (this.place = null), GRACE);
    this.#ask(scenario);
  }

  /** Ends the search and its worker; it can be asked again. */
  close(): void {
    clearTimeout(this.#grace);
    this.#wanted = null;
    this.place = null;
    this.searching = false;
    this.#stop();
  }

  #ask(scenario: Scenario): void {
    if (this.#lost) return this.#found(scenario, this.alone(scenario));
    // The worker hears of nothing before it has ended its search: among many places that takes seconds.
    if (this.#began !== null && performance.now() - this.#began > PATIENCE) this.#stop();
    this.#began ??= performance.now();
    try {
      this.#pool ??= this.open({
        done: ({ scenario: asked }, { place }) => this.#found(asked, place),
        failed: (_, refused) => (refused ? this.#refused() : this.#giveUp()),
      });
      this.#pool.replace([{ scenario }]);
    } catch {
      this.#giveUp();
    }
  }

  #found(scenario: Scenario, place: NextPlace | null): void {
    if (scenario !== this.#wanted) return;
    this.#began = null;
    clearTimeout(this.#grace);
    this.place = place;
    this.searching = false;
  }

  /** Without workers the page searches itself, which it then waits for. */
  #giveUp(): void {
    this.#lost = true;
    if (this.#wanted) this.#ask(this.#wanted);
  }

  /** What is wrong with the scenario its run has told. */
  #refused(): void {
    if (this.#wanted) this.#found(this.#wanted, null);
  }

  #stop(): void {
    this.#pool?.close();
    this.#began = null;
  }
}

/** The page's one search. */
export const nextSearch = new NextSearch(
  (listener) => new WorkerPool(1, startNextWorker, listener),
  bestNext,
);
