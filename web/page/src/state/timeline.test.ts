import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { SPEEDS, Timeline } from "./timeline.svelte";

let now = 0;
const frames: FrameRequestCallback[] = [];
let timelines: Timeline[] = [];

beforeEach(() => {
  now = 0;
  vi.stubGlobal("requestAnimationFrame", (callback: FrameRequestCallback) => frames.push(callback));
  vi.stubGlobal("performance", { now: () => now });
});

/** The loop of frames outlives a test: nothing may be left in it. */
afterEach(async () => {
  for (const timeline of timelines) timeline.pause();
  timelines = [];
  await watch(0.01);
});

/** Lets time go by in frames of 10 ms. */
async function watch(seconds: number): Promise<void> {
  for (let frame = 0; frame < seconds * 100; frame++) {
    now += 10;
    for (const callback of frames.splice(0)) callback(now);
    await Promise.resolve();
  }
}

const tenthsOfASecond = (count: number) => Float64Array.from({ length: count }, (_, step) => step / 10);

function timelineOf(count: number): Timeline {
  const times = tenthsOfASecond(count);
  const timeline = new Timeline(() => times);
  timelines.push(timeline);
  return timeline;
}

test("in real time a second of watching is a second of the run", async () => {
  const timeline = timelineOf(101);
  timeline.play();
  await watch(2);
  expect(timeline.step).toBeGreaterThanOrEqual(19);
  expect(timeline.step).toBeLessThanOrEqual(20);
});

test.each(SPEEDS)("$label goes at its speed", async (speed) => {
  const timeline = timelineOf(10_001);
  timeline.speed = speed;
  timeline.play();
  await watch(10);
  const expected = 10 * (speed.kind === "steps" ? speed.value : speed.value * 10);
  expect(Math.abs(timeline.step - expected)).toBeLessThanOrEqual(1);
});

test("it stops at the end, and starts again where it loops", async () => {
  const timeline = timelineOf(11);
  timeline.play();
  await watch(2);
  expect([timeline.step, timeline.playing]).toEqual([10, false]);
  timeline.loop = true;
  timeline.play();
  const seen = new Set<number>();
  for (let i = 0; i < 30; i++) {
    await watch(0.1);
    seen.add(timeline.step);
  }
  expect(timeline.playing).toBe(true);
  expect([...seen].sort((a, b) => a - b)).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
});

test("it jumps from mark to mark and stays behind the last", () => {
  const timeline = timelineOf(100);
  const marks = [3, 4, 40];
  timeline.toMark(marks, 1);
  expect(timeline.step).toBe(99);
  const steps = [-1, -1, -1, -1, 1].map((direction) => {
    timeline.toMark(marks, direction as 1 | -1);
    return timeline.step;
  });
  expect(steps).toEqual([40, 4, 3, 3, 4]);
});

test("a cursor at the end follows a longer run, one before it stays, none points beyond the run", () => {
  let times = tenthsOfASecond(10);
  const timeline = new Timeline(() => times);
  expect(timeline.step).toBe(9);
  times = tenthsOfASecond(20);
  expect(timeline.step).toBe(19);
  timeline.seek(5);
  times = tenthsOfASecond(30);
  expect(timeline.step).toBe(5);
  times = tenthsOfASecond(3);
  expect(timeline.step).toBe(2);
  times = new Float64Array();
  expect(timeline.step).toBe(0);
});
