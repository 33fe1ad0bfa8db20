import type { Range } from "./range";
import type { ScaleKind } from "./spec";

interface Box {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** What lies along a plot and its values to CSS pixels and back, within the axes of one plot. */
export class Projection {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;

  constructor(
    box: Box,
    pixelRatio: number,
    readonly across: Range,
    readonly acrossScale: ScaleKind,
    readonly values: Range,
    readonly scale: ScaleKind,
  ) {
    this.left = box.left / pixelRatio;
    this.right = (box.left + box.width) / pixelRatio;
    this.top = box.top / pixelRatio;
    this.bottom = (box.top + box.height) / pixelRatio;
  }

  x(along: number): number {
    return this.left + shareOf(along, this.across, this.acrossScale) * (this.right - this.left);
  }

  /** Where a place lies, or the end of the axis where it lies beyond it. */
  clampedX(along: number): number {
    const [first, last] = this.across;
    return this.x(Math.min(last, Math.max(first, along)));
  }

  /** What lies along the plot at a pixel. */
  along(x: number): number {
    return atShare((x - this.left) / (this.right - this.left), this.across, this.acrossScale);
  }

  y(value: number): number {
    return this.bottom - shareOf(value, this.values, this.scale) * (this.bottom - this.top);
  }

  /** The height of a value, or the end of the axis where the value lies beyond it. */
  clampedY(value: number): number {
    const [low, high] = this.values;
    return this.y(Math.min(high, Math.max(low, value)));
  }

  levelAt(y: number): number {
    return atShare((this.bottom - y) / (this.bottom - this.top), this.values, this.scale);
  }

  equals(other: Projection): boolean {
    const numbers = (p: Projection) => [p.left, p.right, p.top, p.bottom, ...p.across, ...p.values];
    const scales = (p: Projection) => [p.acrossScale, p.scale];
    return numbers(this).join() === numbers(other).join() && scales(this).join() === scales(other).join();
  }
}

function shareOf(value: number, [low, high]: Range, scale: ScaleKind): number {
  return scale === "log" ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
}

function atShare(share: number, [low, high]: Range, scale: ScaleKind): number {
  return scale === "log" ? low * (high / low) ** share : low + share * (high - low);
}
