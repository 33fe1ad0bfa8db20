import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { FieldProgram } from "./field";
import { type ComputingScene, FAST, FineField, REST } from "./fine-field";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

const program = (number: number, text = "kernel"): FieldProgram => ({
  key: text,
  text,
  parameters: Float32Array.of(number),
  width: 512,
  height: 256,
});

/** A device that takes `cost` milliseconds a field and writes down what it is asked for. */
function setup(cost: number, compile: () => Promise<void> = () => Promise.resolve()) {
  const device = { cost, lost: false, error: null as Error | null };
  const log: string[] = [];
  const scene: ComputingScene = {
    set_field_kernel: (text) => (log.push(text), compile()),
    compute_field: async ([number], width, height) => {
      log.push(`compute ${number}, ${width} x ${height}`);
      await new Promise((resolve) => setTimeout(resolve, device.cost));
      if (device.error) throw device.error;
    },
    drop_fine_field: () => void log.push("drop"),
    lost: () => device.lost,
  };
  const filled = vi.fn(() => void log.push("filled"));
  const fine = new FineField(scene, filled);
  const taken = () => log.splice(0);
  return { fine, device, filled, taken };
}

/** A device that has shown that it is fast. */
async function fastDevice() {
  const made = setup(FAST / 2);
  made.fine.show(program(0));
  await vi.advanceTimersByTimeAsync(REST + FAST);
  expect(made.taken()).toEqual(["kernel", "compute 0, 512 x 256", "filled"]);
  return made;
}

test("a fast device computes each field at once, and compiles a text once", async () => {
  const { fine, taken } = await fastDevice();
  const [one, other] = [program(1), program(2, "other")];
  fine.show(one);
  expect(fine.filled).toBe(false);
  await vi.advanceTimersByTimeAsync(FAST);
  expect(fine.filled).toBe(true);
  fine.show(one);
  await vi.advanceTimersByTimeAsync(REST);
  expect(taken()).toEqual(["drop", "compute 1, 512 x 256", "filled"]);
  fine.show(other);
  await vi.advanceTimersByTimeAsync(FAST);
  expect(taken()).toEqual(["drop", "other", "compute 2, 512 x 256", "filled"]);
});

test("one computation is under way, and the latest wins", async () => {
  const { fine, taken } = await fastDevice();
  for (const number of [1, 2, 3]) fine.show(program(number));
  expect(taken()).toEqual(["drop", "compute 1, 512 x 256", "drop"]);
  await vi.advanceTimersByTimeAsync(2 * FAST);
  expect(taken()).toEqual(["compute 3, 512 x 256", "filled"]);
});

test("a slow device waits until no picture has come for a while", async () => {
  const { fine, device, taken } = await fastDevice();
  device.cost = 2 * FAST;
  fine.show(program(1));
  await vi.advanceTimersByTimeAsync(2 * FAST);
  expect(taken()).toEqual(["drop", "compute 1, 512 x 256", "filled"]);
  for (let number = 2; number < 12; number++) {
    fine.show(program(number));
    await vi.advanceTimersByTimeAsync(REST - 1);
  }
  expect(taken()).toEqual(["drop"]);
  await vi.advanceTimersByTimeAsync(1);
  expect(taken()).toEqual(["compute 11, 512 x 256"]);
});

test("a picture of the same field puts off a slow device too", async () => {
  const { fine, taken } = setup(2 * FAST);
  const same = program(1);
  for (let picture = 0; picture < 5; picture++) {
    fine.show(same);
    await vi.advanceTimersByTimeAsync(REST - 1);
  }
  expect(taken()).toEqual([]);
});

test("what is not shown any more is not computed", async () => {
  let compiled = () => {};
  const { fine, filled, taken } = setup(1, () => new Promise((resolve) => (compiled = resolve)));
  fine.show(program(1));
  await vi.advanceTimersByTimeAsync(REST);
  fine.show(null);
  compiled();
  await vi.advanceTimersByTimeAsync(2 * REST);
  expect(taken()).toEqual(["kernel"]);
  expect(filled).not.toHaveBeenCalled();
});

test("a rejected kernel is told once, and nothing is asked again", async () => {
  const warn = vi.spyOn(console, "warn").mockImplementation(() => {});
  const { fine, taken } = setup(1, () => Promise.reject(new Error("line 3")));
  for (const number of [1, 2]) {
    fine.show(program(number));
    await vi.advanceTimersByTimeAsync(REST);
  }
  expect(taken()).toEqual(["kernel"]);
  expect(warn).toHaveBeenCalledOnce();
  warn.mockRestore();
});

test("a rejected computation is told once and leaves no fine field; that of a lost device is not told", async () => {
  for (const lost of [false, true]) {
    const warn = vi.spyOn(console, "warn").mockImplementation(() => {});
    const { fine, device, filled } = await fastDevice();
    Object.assign(device, { lost, error: new Error("refused") });
    for (const number of [1, 2]) {
      fine.show(program(number));
      await vi.advanceTimersByTimeAsync(REST);
    }
    expect(fine.filled).toBe(false);
    expect(filled).toHaveBeenCalledOnce();
    expect(warn).toHaveBeenCalledTimes(lost ? 0 : 1);
    warn.mockRestore();
  }
});

test("a renderer that is freed hears nothing and touches nothing", async () => {
  const { fine, taken } = await fastDevice();
  fine.show(program(1));
  taken();
  fine.stop();
  await vi.advanceTimersByTimeAsync(REST);
  expect(taken()).toEqual([]);
});
