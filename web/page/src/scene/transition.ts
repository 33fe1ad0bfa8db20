import type { Camera } from "./camera";
import { add, scale, sub } from "./geometry";

/** Milliseconds from one preset view to another. */
const DURATION = 280;

/** The camera on its way: share 0 at `from`, 1 at `to`; distances change by equal factors, turns go the short way. */
export function between(from: Camera, to: Camera, share: number): Camera {
  const eased = share * share * (3 - 2 * share);
  const turn = to.yaw - from.yaw - 2 * Math.PI * Math.round((to.yaw - from.yaw) / (2 * Math.PI));
  return {
    target: add(from.target, scale(sub(to.target, from.target), eased)),
    yaw: from.yaw + turn * eased,
    pitch: from.pitch + (to.pitch - from.pitch) * eased,
    distance: from.distance * (to.distance / from.distance) ** eased,
    orthographic: to.orthographic,
  };
}

/** One transition at a time; where less motion is preferred the camera is there at once. */
export class Transition {
  #frame = 0;
  #to: Camera | null = null;

  start(from: Camera, to: Camera, show: (camera: Camera) => void): void {
    this.stop();
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return show(to);
    this.#to = to;
    const began = performance.now();
    const next = (now: number) => {
      const share = Math.min(1, Math.max(0, (now - began) / DURATION));
      show(share < 1 ? between(from, to, share) : to);
      if (share < 1) this.#frame = requestAnimationFrame(next);
      else this.#to = null;
    };
    this.#frame = requestAnimationFrame(next);
  }

  /** Ends where it is; returns where it was going, null where it had arrived. */
  stop(): Camera | null {
    cancelAnimationFrame(this.#frame);
    const to = this.#to;
    this.#to = null;
    return to;
  }
}
