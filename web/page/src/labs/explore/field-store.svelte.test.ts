import { expect, test } from "vitest";
import type { Scenario } from "../../scenario";
import type { FieldSource } from "./field-source";
import { FieldStore } from "./field-store.svelte";
import { type Idle, IdleRefiner } from "./idle-refiner";

const scenario = (seed: number) => ({ seed }) as Scenario;

/** A source whose cells tell scenario and row, and take `cost` milliseconds each. */
function setup(cost: number) {
  let [time, next] = [0, 1];
  const tasks = new Map<number, () => void>();
  const idle: Idle = {
    request: (task) => (tasks.set(next, task), next++),
    cancel: (request) => tasks.delete(request),
    now: () => time,
  };
  const source: FieldSource = {
    layout: (_, width) => ({ corner: [0, 0, 0], u: [2, 0, 0], v: [0, 1, 0], width, height: width / 2 }),
    rows: ({ seed }, width, first, count) => {
      time += cost * width * count;
      return Float32Array.from(
        { length: width * count },
        (_, at) => 1000 * seed + first + Math.floor(at / width),
      );
    },
  };
  const turn = () => {
    const [entry] = tasks;
    if (!entry) return false;
    tasks.delete(entry[0]);
    entry[1]();
    return true;
  };
  return { store: new FieldStore(source, new IdleRefiner(source, idle), idle.now), turn, time: () => time };
}

test("a coarse field is there at once, finer ones come with every row in its place", () => {
  const { store, turn } = setup(0.001);
  store.show(scenario(3));
  expect(store.field?.resolution).toBe(64);
  const seen = new Set<number>();
  while (turn()) seen.add(store.field!.resolution);
  expect([...seen]).toEqual([64, 128, 256]);
  const { values, width, height } = store.field!;
  expect(values).toHaveLength(width * height);
  expect(Array.from(values).every((value, at) => value === 3000 + Math.floor(at / width))).toBe(true);
});

test("the next scenario cancels what is being refined", () => {
  const { store, turn } = setup(0.001);
  store.show(scenario(1));
  turn();
  store.show(scenario(2));
  expect([store.field?.resolution, store.field?.values[0]]).toEqual([64, 2000]);
  while (turn()) expect(store.field!.values[0]).toBe(2000);
  expect(store.field?.resolution).toBe(256);
});

test("where cells are dear the next coarse field has as many as fit, and idle moments stay short", () => {
  const { store, turn, time } = setup(0.05);
  store.show(scenario(1));
  const before = time();
  store.show(scenario(2));
  expect(store.field?.resolution).toBe(16);
  expect(time() - before).toBeLessThan(8);
  let start = time();
  while (turn()) {
    expect(time() - start).toBeLessThan(6 + 4 * 256 * 0.05 + 1e-9);
    start = time();
  }
  expect(store.field?.resolution).toBe(256);
});
