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
  step = $state(0);
  /** The step under the pointer in a plot, or null. */
  hovered: number | null = $state(null);
  count = $state(1);
  playing = $state(false);
  /** Starts again at the end. */
  loop = $state(false);
  speed: Speed = $state.raw(REAL_TIME);
  /** Mean time between steps, s. */
  #interval = $state(1);
  #lastTick = 0;
  #carry = 0;

  get last(): number {
    return this.count - 1;
  }

  /** Steps per second of watching. */
  get rate(): number {
    return this.speed.kind === "steps" ? this.speed.value : this.speed.value / this.#interval;
  }

  /** Follows a new run, whose steps have these times: a cursor at the end stays at the end. */
  follow(times: Float64Array): void {
    const atEnd = this.step === this.last;
    this.count = Math.max(1, times.length);
    const span = times[this.last] - times[0];
    this.#interval = span > 0 ? span / this.last : 1;
    if (atEnd || this.step > this.last) this.step = this.last;
  }

  seek(step: number): void {
    this.step = Math.min(this.last, Math.max(0, Math.round(step)));
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
    if (this.step >= this.last) this.step = 0;
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
    this.step = 0;
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
    else if (this.loop && this.last > 0) this.step = 0;
    if (this.step === this.last && !this.loop) this.pause();
  }
}
