import { scheduleCompute } from "./frames";

export const RATES = [1, 2, 5, 10, 20, 50] as const;

/** The cursor in time: which step of the run is shown, and whether it is moving. */
export class Timeline {
  step = $state(0);
  /** The step under the pointer in a plot, or null. */
  hovered: number | null = $state(null);
  count = $state(1);
  playing = $state(false);
  /** Steps per second of watching. */
  rate = $state(5);
  #lastTick = 0;
  #carry = 0;

  get last(): number {
    return this.count - 1;
  }

  /** Follows a new run: a cursor at the end stays at the end. */
  setCount(count: number): void {
    const atEnd = this.step === this.last;
    this.count = Math.max(1, count);
    if (atEnd || this.step > this.last) this.step = this.last;
  }

  seek(step: number): void {
    this.step = Math.min(this.last, Math.max(0, Math.round(step)));
  }

  stepBy(delta: number): void {
    this.pause();
    this.seek(this.step + delta);
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
    if (whole > 0) this.seek(this.step + whole);
    if (this.step >= this.last) this.pause();
    else queueMicrotask(() => scheduleCompute(this.#tick));
  };
}
