import type { Timeline } from "../state/timeline.svelte";
import type { PlotAxis } from "./spec";
import { nearestStep } from "./thin";

/** Which step of a plot is read. Along time it is the timeline's, shared by all plots; along anything else its own. */
export class PlotCursor {
  #own: number | null = $state(null);
  readonly #axis: () => PlotAxis;
  readonly #timeline: Timeline;

  constructor(axis: () => PlotAxis, timeline: Timeline) {
    this.#axis = axis;
    this.#timeline = timeline;
  }

  get timed(): boolean {
    return this.#axis().now === null;
  }

  get last(): number {
    return this.#axis().values.length - 1;
  }

  /** Where the scenario lies: a step of the run, or the step nearest to its own value. */
  get now(): number {
    const axis = this.#axis();
    return Math.min(axis.now === null ? this.#timeline.step : nearestStep(axis, axis.now), this.last);
  }

  get pointed(): number | null {
    const step = this.timed ? this.#timeline.hovered : this.#own;
    return step === null ? null : Math.min(step, this.last);
  }

  point(step: number | null): void {
    if (this.timed) this.#timeline.hovered = step;
    else this.#own = step;
  }

  /** A press: time goes there. */
  seek(step: number): void {
    if (!this.timed) return;
    this.#timeline.pause();
    this.#timeline.seek(step);
  }

  /** Reads so many steps farther on, from where the scenario lies at first. */
  read(by: number): void {
    this.point(Math.min(this.last, Math.max(0, (this.pointed ?? this.now) + by)));
  }
}
