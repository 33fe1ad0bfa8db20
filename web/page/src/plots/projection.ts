import type { Range } from "./range";
import type { ScaleKind } from "./spec";

interface Box {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** Times and values to CSS pixels and back, within the axes of one plot. */
export class Projection {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;

  constructor(
    box: Box,
    pixelRatio: number,
    readonly times: Range,
    readonly values: Range,
    readonly scale: ScaleKind,
  ) {
    this.left = box.left / pixelRatio;
    this.right = (box.left + box.width) / pixelRatio;
    this.top = box.top / pixelRatio;
    this.bottom = (box.top + box.height) / pixelRatio;
  }

  x(time: number): number {
    const [first, last] = this.times;
    return this.left + ((time - first) / (last - first)) * (this.right - this.left);
  }

  timeAt(x: number): number {
    const [first, last] = this.times;
    return first + ((x - this.left) / (this.right - this.left)) * (last - first);
  }

  y(value: number): number {
    const [low, high] = this.values;
    const share =
      this.scale === "log" ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
    return this.bottom - share * (this.bottom - this.top);
  }

  /** The height of a value, or the end of the axis where the value lies beyond it. */
  clampedY(value: number): number {
    const [low, high] = this.values;
    return this.y(Math.min(high, Math.max(low, value)));
  }

  levelAt(y: number): number {
    const [low, high] = this.values;
    const share = (this.bottom - y) / (this.bottom - this.top);
    return this.scale === "log" ? low * (high / low) ** share : low + share * (high - low);
  }

  equals(other: Projection): boolean {
    const numbers = (p: Projection) => [p.left, p.right, p.top, p.bottom, ...p.times, ...p.values, p.scale];
    return numbers(this).join() === numbers(other).join();
  }
}
