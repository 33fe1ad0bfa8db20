import type { Answer, Request } from "./messages";

/** A worker as the pool needs it; tests bring one without a thread. */
export interface PoolWorker<Job, Result> {
  onmessage: ((event: MessageEvent<Answer<Result>>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  onmessageerror: ((event: MessageEvent) => void) | null;
  postMessage(request: Request<Job>): void;
  terminate(): void;
}

/** What the pool tells: results come in any order, those of an older list never. */
export interface PoolListener<Job, Result> {
  done(job: Job, result: Result): void;
  /** The work has ended, with the reason as a sentence: the job was refused, or workers could not be kept alive. */
  failed(sentence: string, refused: boolean): void;
}

/** Losses without a success in between that are taken as bad luck, for each worker. */
const LOSSES = 3;
/** A worker is given up when it takes longer than this, if nothing else is said, and than so many times the longest job so far. */
const LEAST_PATIENCE_MS = 20_000;
const PATIENCE_FACTOR = 10;

interface Slot<Job, Result> {
  worker: PoolWorker<Job, Result>;
  job: Job | null;
  since: number;
  timer: ReturnType<typeof setTimeout> | undefined;
}

/** Workers that do jobs; one that dies is replaced and its job is done again. */
export class WorkerPool<Job extends object, Result> {
  readonly #slots: Slot<Job, Result>[] = [];
  readonly #abandoned = new WeakSet<Job>();
  #queue: Job[] = [];
  #held = false;
  #losses = 0;
  #longest = 0;

  constructor(
    private readonly size: number,
    private readonly spawn: () => PoolWorker<Job, Result>,
    private readonly listener: PoolListener<Job, Result>,
    private readonly leastPatience = LEAST_PATIENCE_MS,
  ) {}

  /** Forgets what it was doing, at the next job, and does these instead. */
  replace(jobs: readonly Job[]): void {
    for (const { job } of this.#slots) if (job) this.#abandoned.add(job);
    this.#queue = [...jobs];
    this.#losses = 0;
    this.#advance();
  }

  /** Begins no more jobs; those begun are still told. */
  hold(): void {
    this.#held = true;
  }

  proceed(): void {
    this.#held = false;
    this.#advance();
  }

  /** Ends the workers and what they do; the next jobs start others. */
  close(): void {
    this.#queue = [];
    for (const slot of this.#slots.splice(0)) this.#dismiss(slot);
  }

  #advance(): void {
    if (this.#held) return;
    while (this.#queue.length > 0) {
      const slot = this.#slots.find((candidate) => candidate.job === null) ?? this.#grow();
      if (!slot) return;
      this.#begin(slot, this.#queue.shift()!);
    }
  }

  #grow(): Slot<Job, Result> | null {
    if (this.#slots.length >= this.size) return null;
    const slot: Slot<Job, Result> = { worker: this.spawn(), job: null, since: 0, timer: undefined };
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

  #begin(slot: Slot<Job, Result>, job: Job): void {
    slot.job = job;
    slot.since = performance.now();
    const patience = Math.max(this.leastPatience, PATIENCE_FACTOR * this.#longest);
    slot.timer = setTimeout(() => this.#lost(slot), patience);
    slot.worker.postMessage({ kind: "job", job });
  }

  #answered(slot: Slot<Job, Result>, answer: Answer<Result>): void {
    const { job } = slot;
    if (!job) return;
    clearTimeout(slot.timer);
    slot.job = null;
    this.#losses = 0;
    this.#longest = Math.max(this.#longest, performance.now() - slot.since);
    if (!this.#abandoned.has(job)) {
      if (answer.kind === "done") this.listener.done(job, answer.result);
      else this.#giveUp(answer.sentence, true);
    }
    this.#advance();
  }

  #lost(slot: Slot<Job, Result>): void {
    const index = this.#slots.indexOf(slot);
    if (index < 0) return;
    this.#slots.splice(index, 1);
    this.#dismiss(slot);
    if (slot.job && !this.#abandoned.has(slot.job)) this.#queue.unshift(slot.job);
    this.#losses += 1;
    if (this.#losses < LOSSES * this.size) this.#advance();
    else this.#giveUp(`The workers stopped ${this.#losses} times in a row.`, false);
  }

  #giveUp(sentence: string, refused: boolean): void {
    this.replace([]);
    this.listener.failed(sentence, refused);
  }

  #dismiss({ worker, timer }: Slot<Job, Result>): void {
    clearTimeout(timer);
    worker.onmessage = worker.onerror = worker.onmessageerror = null;
    worker.terminate();
  }
}
