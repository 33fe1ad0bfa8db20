import { flushSync } from "svelte";

/**
 * One loop for everything that follows an animation frame: compute first, then let the page react, then draw.
 * A task asked for many times within a frame runs once, so a burst of pointer events costs one computation.
 */
type Task = () => void;
const compute = new Set<Task>();
const draw = new Set<Task>();
let pending = false;

export function scheduleCompute(task: Task): void {
  compute.add(task);
  request();
}

export function scheduleDraw(task: Task): void {
  draw.add(task);
  request();
}

function request(): void {
  if (pending) return;
  pending = true;
  requestAnimationFrame(() => {
    runAll(compute);
    runOne(flushSync);
    pending = false;
    runAll(draw);
  });
}

/** A task that fails is told like any other error of the page and holds up no other one. */
function runOne(task: Task): void {
  try {
    task();
  } catch (error) {
    reportError(error);
  }
}

function runAll(tasks: Set<Task>): void {
  const now = [...tasks];
  tasks.clear();
  for (const task of now) runOne(task);
}
