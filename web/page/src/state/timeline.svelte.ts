import { scheduleCompute } from "./frames";

/** How fast time goes by: so many times the real one, or so many steps a second whatever time they take. */
export interface Speed {
  readonly kind: "real time" | "steps";
  readonly value: number;
  readonly label: string;
}

export const SPEEDS: readonly Speed[] = [
  ...[0.1, 0.2, 0.5, 1, 2, 5, 10].map((value): Speed => ({ kind: "real time", value, label: `${value} ×` })),
  ...[1, 2, 5, 10, 20, 50].map((value): Speed => ({ kind: "steps", value, label: `${value} steps/s` })),
];
const REAL_TIME = SPEEDS.find((speed) => speed.kind === "real time" && speed.value === 1) ?? SPEEDS[0];

/** The cursor in time: which step of the run is shown, and whether it is moving. */
export class Timeline {
  /** The step under the pointer in a plot, or null. */
  hovered: number | null = $state(null);
  playing = $state(false);
  /** Starts again at the end. */
  loop = $state(false);
  speed: Speed = $state.raw(REAL_TIME);
  /** What was asked for; `Infinity` is the end, wherever that comes to lie. */
  #wanted = $state(Infinity);
  readonly #times: () => Float64Array;
  #lastTick = 0;
  #carry = 0;

  /** `times` gives those of the run's steps, in seconds. */
  constructor(times: () => Float64Array) {
    this.#times = times;
  }

  /** The step that is shown: always one that the run has, also in the moment a shorter one comes. */
  get step(): number {
    return Math.min(this.#wanted, this.last);
  }

  get count(): number {
    return Math.max(1, this.#times().length);
  }

  get last(): number {
    return this.count - 1;
  }

  /** Steps per second of watching. */
  get rate(): number {
    if (this.speed.kind === "steps") return this.speed.value;
    const times = this.#times();
    const span = times[this.last] - times[0];
    return span > 0 ? (this.speed.value * this.last) / span : this.speed.value;
  }

  /** Goes to a step; at the end the cursor stays at the end, also of a longer run. */
  seek(step: number): void {
    this.#wanted = step >= this.last ? Infinity : Math.max(0, Math.round(step));
  }

  stepBy(delta: number): void {
    this.pause();
    this.seek(this.step + delta);
  }

  /** To the nearest of the marked steps before or after this one; stays where there is none. */
  toMark(marks: readonly number[], direction: 1 | -1): void {
    const ahead = marks.filter((mark) => (mark - this.step) * direction > 0);
    if (ahead.length > 0)
      this.stepBy(direction * Math.min(...ahead.map((mark) => Math.abs(mark - this.step))));
  }

  play(): void {
    if (this.step >= this.last) this.#wanted = 0;
    this.playing = true;
    this.#lastTick = performance.now();
    this.#carry = 0;
    scheduleCompute(this.#tick);
  }

  pause(): void {
    this.playing = false;
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  reset(): void {
    this.pause();
    this.#wanted = 0;
  }

  #tick = (): void => {
    if (!this.playing) return;
    const now = performance.now();
    this.#carry += ((now - this.#lastTick) / 1000) * this.rate;
    this.#lastTick = now;
    const whole = Math.floor(this.#carry);
    this.#carry -= whole;
    if (whole > 0) this.#advance(whole);
    if (this.playing) queueMicrotask(() => scheduleCompute(this.#tick));
  };

  /** The last step is always shown, however fast, before the first one comes again. */
  #advance(steps: number): void {
    if (this.step < this.last) this.seek(this.step + steps);
    else if (this.loop && this.last > 0) this.#wanted = 0;
    if (this.step === this.last && !this.loop) this.pause();
  }
}
