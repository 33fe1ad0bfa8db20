import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import type { Scenario } from "../scenario";
import { InOrder } from "./in-order";
import type { Answer, Block, Request, Sums } from "./messages";
import { type PoolWorker, WorkerPool } from "./pool";

type BlockWorker = PoolWorker<Block, Sums>;

/** A worker that answers when it is told to. */
class FakeWorker implements BlockWorker {
  onmessage: BlockWorker["onmessage"] = null;
  onerror: BlockWorker["onerror"] = null;
  onmessageerror: BlockWorker["onmessageerror"] = null;
  readonly blocks: Block[] = [];
  terminated = false;

  postMessage(request: Request<Block>): void {
    if (request.kind === "job") this.blocks.push(request.job);
  }
  terminate(): void {
    this.terminated = true;
  }
  answer(answer: Answer<Sums> = { kind: "done", result: Float64Array.of(this.last.firstTrial) }): void {
    this.onmessage?.({ data: answer } as MessageEvent<Answer<Sums>>);
  }
  crash(): void {
    this.onerror?.({ preventDefault: () => undefined } as ErrorEvent);
  }
  get last(): Block {
    return this.blocks[this.blocks.length - 1];
  }
}

const blocks = (count: number, name = ""): Block[] =>
  Array.from({ length: count }, (_, i) => ({
    scenario: { name } as Scenario,
    firstTrial: 20 * i,
    trials: 20,
  }));

function start(size: number) {
  const workers: FakeWorker[] = [];
  const done: number[] = [];
  const failures: string[] = [];
  const pool = new WorkerPool(
    size,
    () => {
      const worker = new FakeWorker();
      workers.push(worker);
      return worker;
    },
    {
      done: (block, sums) => {
        expect(sums[0]).toBe(block.firstTrial);
        done.push(block.firstTrial);
      },
      failed: (sentence, refused) => failures.push(refused ? `Refused: ${sentence}` : sentence),
    },
  );
  return { pool, workers, done, failures };
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

describe("the pool", () => {
  test("keeps every worker busy and does every block once", () => {
    const { pool, workers, done } = start(2);
    pool.replace(blocks(5));
    expect(workers.map((worker) => worker.last.firstTrial)).toEqual([0, 20]);
    for (const k of [1, 1, 0, 1, 0]) workers[k].answer();
    expect(done.toSorted((a, b) => a - b)).toEqual([0, 20, 40, 60, 80]);
    expect(workers).toHaveLength(2);
  });

  test("starts no more workers than there are blocks", () => {
    const { pool, workers } = start(8);
    pool.replace(blocks(3));
    expect(workers).toHaveLength(3);
  });

  test("drops old work at the next block: its answers are not told", () => {
    const { pool, workers, done } = start(1);
    pool.replace(blocks(3, "old"));
    pool.replace(blocks(2, "new"));
    expect(workers[0].blocks).toHaveLength(1);
    workers[0].answer();
    expect(done).toEqual([]);
    expect(workers[0].last.scenario.name).toBe("new");
    workers[0].answer();
    expect(done).toEqual([0]);
  });

  test("holds and proceeds without losing a block", () => {
    const { pool, workers, done } = start(1);
    pool.replace(blocks(2));
    pool.hold();
    workers[0].answer();
    expect(workers[0].blocks).toHaveLength(1);
    pool.proceed();
    workers[0].answer();
    expect(done).toEqual([0, 20]);
  });

  test.each([
    ["crashes", (worker: FakeWorker) => worker.crash()],
    ["cannot be understood", (worker: FakeWorker) => worker.onmessageerror?.({} as MessageEvent)],
    ["is silent", () => vi.advanceTimersByTime(20_001)],
  ])("replaces a worker that %s and does its block again", (_what, lose) => {
    const { pool, workers, done, failures } = start(1);
    pool.replace(blocks(2));
    workers[0].answer();
    lose(workers[0]);
    expect(workers[0].terminated).toBe(true);
    workers[1].answer();
    expect(done).toEqual([0, 20]);
    expect(failures).toEqual([]);
  });

  test("does not bring the block of a cancelled study back with a lost worker", () => {
    const { pool, workers, done } = start(1);
    pool.replace(blocks(1, "old"));
    pool.replace(blocks(1, "new"));
    workers[0].crash();
    expect(workers[1].last.scenario.name).toBe("new");
    workers[1].answer();
    expect(done).toEqual([0]);
  });

  test("says in one sentence that workers keep dying, and begins anew with the next list", () => {
    const { pool, workers, done, failures } = start(2);
    pool.replace(blocks(4));
    for (let i = 0; i < 50; i++) workers.filter((worker) => !worker.terminated)[0]?.crash();
    expect(failures).toEqual(["The workers stopped 6 times in a row."]);
    pool.replace(blocks(1));
    workers[workers.length - 1].answer();
    expect(done).toEqual([0]);
  });

  test("stops where the engine refuses the scenario, with its sentence", () => {
    const { pool, workers, failures } = start(1);
    pool.replace(blocks(3));
    workers[0].answer({ kind: "refused", sentence: "No anchor." });
    expect(failures).toEqual(["Refused: No anchor."]);
    expect(workers[0].blocks).toHaveLength(1);
  });

  test("waits longer for blocks that are known to take long", () => {
    const { pool, workers } = start(1);
    pool.replace(blocks(3));
    vi.advanceTimersByTime(15_000);
    workers[0].answer();
    vi.advanceTimersByTime(140_000);
    expect(workers[0].terminated).toBe(false);
    vi.advanceTimersByTime(20_000);
    expect(workers[0].terminated).toBe(true);
  });

  test("ends its workers when it is closed", () => {
    const { pool, workers } = start(2);
    pool.replace(blocks(2));
    pool.close();
    expect(workers.every((worker) => worker.terminated)).toBe(true);
  });
});

test("what comes in any order leaves in order", () => {
  const order = new InOrder<string>();
  expect(order.accept(2, "c")).toEqual([]);
  expect(order.accept(0, "a")).toEqual(["a"]);
  expect(order.accept(1, "b")).toEqual(["b", "c"]);
  expect(order.accept(3, "d")).toEqual(["d"]);
});
