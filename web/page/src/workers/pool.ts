import type { Answer, Block, Request } from "./messages";

/** A worker as the pool needs it; tests bring one without a thread. */
export interface StudyWorker {
  onmessage: ((event: MessageEvent<Answer>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  onmessageerror: ((event: MessageEvent) => void) | null;
  postMessage(request: Request): void;
  terminate(): void;
}

/** What the pool tells: sums come in any order, blocks of an older list never. */
export interface PoolListener {
  done(block: Block, sums: Float64Array): void;
  /** The work has ended, with the reason as a sentence. */
  failed(sentence: string): void;
}

/** Losses without a success in between that are taken as bad luck, for each worker. */
const LOSSES = 3;
/** A worker is given up when it takes longer than this, and than so many times the longest block so far. */
const LEAST_PATIENCE_MS = 20_000;
const PATIENCE_FACTOR = 10;

interface Slot {
  worker: StudyWorker;
  block: Block | null;
  since: number;
  timer: ReturnType<typeof setTimeout> | undefined;
}

/** Workers that run blocks of trials; one that dies is replaced and its block is done again. */
export class WorkerPool {
  readonly #slots: Slot[] = [];
  readonly #abandoned = new WeakSet<Block>();
  #queue: Block[] = [];
  #held = false;
  #losses = 0;
  #longest = 0;

  constructor(
    private readonly size: number,
    private readonly spawn: () => StudyWorker,
    private readonly listener: PoolListener,
  ) {}

  /** Forgets what it was doing, at the next block, and does these instead. */
  replace(blocks: readonly Block[]): void {
    for (const { block } of this.#slots) if (block) this.#abandoned.add(block);
    this.#queue = [...blocks];
    this.#losses = 0;
    this.#advance();
  }

  /** Begins no more blocks; those begun are still told. */
  hold(): void {
    this.#held = true;
  }

  proceed(): void {
    this.#held = false;
    this.#advance();
  }

  close(): void {
    this.#queue = [];
    for (const slot of this.#slots.splice(0)) this.#dismiss(slot);
  }

  #advance(): void {
    if (this.#held) return;
    while (this.#queue.length > 0) {
      const slot = this.#slots.find((candidate) => candidate.block === null) ?? this.#grow();
      if (!slot) return;
      this.#begin(slot, this.#queue.shift()!);
    }
  }

  #grow(): Slot | null {
    if (this.#slots.length >= this.size) return null;
    const slot: Slot = { worker: this.spawn(), block: null, since: 0, timer: undefined };
    slot.worker.onmessage = ({ data }) => this.#answered(slot, data);
    slot.worker.onerror = (event) => {
      // Told below if it goes on: the console need not hear of each.
      event.preventDefault();
      this.#lost(slot);
    };
    slot.worker.onmessageerror = () => this.#lost(slot);
    this.#slots.push(slot);
    return slot;
  }

  #begin(slot: Slot, block: Block): void {
    slot.block = block;
    slot.since = performance.now();
    const patience = Math.max(LEAST_PATIENCE_MS, PATIENCE_FACTOR * this.#longest);
    slot.timer = setTimeout(() => this.#lost(slot), patience);
    slot.worker.postMessage({ kind: "block", block });
  }

  #answered(slot: Slot, answer: Answer): void {
    const { block } = slot;
    if (!block) return;
    clearTimeout(slot.timer);
    slot.block = null;
    this.#losses = 0;
    this.#longest = Math.max(this.#longest, performance.now() - slot.since);
    if (!this.#abandoned.has(block)) {
      if (answer.kind === "sums") this.listener.done(block, answer.sums);
      else this.#giveUp(answer.sentence);
    }
    this.#advance();
  }

  #lost(slot: Slot): void {
    const index = this.#slots.indexOf(slot);
    if (index < 0) return;
    this.#slots.splice(index, 1);
    this.#dismiss(slot);
    if (slot.block && !this.#abandoned.has(slot.block)) this.#queue.unshift(slot.block);
    this.#losses += 1;
    if (this.#losses < LOSSES * this.size) this.#advance();
    else this.#giveUp(`The workers that run the trials stopped ${this.#losses} times in a row.`);
  }

  #giveUp(sentence: string): void {
    this.replace([]);
    this.listener.failed(sentence);
  }

  #dismiss({ worker, timer }: Slot): void {
    clearTimeout(timer);
    worker.onmessage = worker.onerror = worker.onmessageerror = null;
    worker.terminate();
  }
}
