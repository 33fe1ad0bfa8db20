import { scale, type Vec3 } from "./geometry";

/** Red, green, blue, alpha in 0..1, as sRGB values. */
export type Color = readonly [number, number, number, number];

export const SHAPES = { disc: 0, ring: 1, square: 2, triangle: 3, diamond: 4, cross: 5 } as const;
export type Shape = keyof typeof SHAPES;

/** Numbers per element; the layouts are the renderer's. */
export const STRIDE = { segment: 13, point: 9, ellipsoid: 16, vertex: 10 } as const;

/** Floats that grow by doubling and are reused from picture to picture. */
class FloatList {
  #values = new Float32Array(1024);
  #length = 0;

  push(...values: number[]): void {
    this.copy(values, 0, values.length);
  }

  copy(source: ArrayLike<number>, from: number, count: number): void {
    if (this.#length + count > this.#values.length) {
      const larger = new Float32Array(this.#values.length * 2);
      larger.set(this.#values);
      this.#values = larger;
    }
    for (let i = 0; i < count; i++) this.#values[this.#length + i] = source[from + i];
    this.#length += count;
  }

  clear(): void {
    this.#length = 0;
  }

  get view(): Float32Array {
    return this.#values.subarray(0, this.#length);
  }
}

export interface LineStyle {
  readonly width: number;
  readonly color: Color;
  /** Length of a dash and of the gap after it; 0 is a full line. */
  readonly dash?: number;
  /** Drawn over everything that would hide it. */
  readonly overlay?: boolean;
}

/** What one picture consists of. Widths and radii are CSS pixels; the lists hold physical ones. */
export class DrawList {
  readonly #segments = new FloatList();
  readonly #points = new FloatList();
  readonly #ellipsoids = new FloatList();
  readonly #triangles = new FloatList();
  /** Physical pixels per CSS pixel. */
  pixelRatio = 1;
  /** Lines and marks are this many times heavier, for the last row. */
  weight = 1;

  get segments(): Float32Array {
    return this.#segments.view;
  }
  get points(): Float32Array {
    return this.#points.view;
  }
  get ellipsoids(): Float32Array {
    return this.#ellipsoids.view;
  }
  get triangles(): Float32Array {
    return this.#triangles.view;
  }

  clear(): void {
    for (const list of [this.#segments, this.#points, this.#ellipsoids, this.#triangles]) list.clear();
  }

  line(start: Vec3, end: Vec3, style: LineStyle): void {
    if (!drawable(start) || !drawable(end)) return;
    const pixels = this.pixelRatio;
    this.#segments.push(...start, ...end, style.width * this.weight * pixels, (style.dash ?? 0) * pixels);
    this.#segments.push(...style.color, style.overlay ? 1 : 0);
  }

  polyline(points: readonly Vec3[], style: LineStyle): void {
    for (let i = 1; i < points.length; i++) this.line(points[i - 1], points[i], style);
  }

  /** Lines through the points of a flat list of coordinates, from one index to another. */
  path(coordinates: Float32Array, first: number, last: number, style: LineStyle): void {
    const width = style.width * this.weight * this.pixelRatio;
    const look = [width, (style.dash ?? 0) * this.pixelRatio, ...style.color, style.overlay ? 1 : 0];
    for (let at = 3 * first; at < 3 * last; at += 3) {
      let far = false;
      for (let i = at; i < at + 6; i++) far ||= !(Math.abs(coordinates[i]) < FARTHEST);
      if (far) continue;
      this.#segments.copy(coordinates, at, 6);
      this.#segments.copy(look, 0, look.length);
    }
  }

  point(centre: Vec3, radius: number, color: Color, shape: Shape): void {
    if (!drawable(centre)) return;
    this.#points.push(...centre, radius * Math.sqrt(this.weight) * this.pixelRatio, ...color, SHAPES[shape]);
  }

  ellipsoid(centre: Vec3, axes: readonly [Vec3, Vec3, Vec3], color: Color): void {
    if (![centre, ...axes].every(drawable)) return;
    this.#ellipsoids.push(...centre, ...axes[0], ...axes[1], ...axes[2], ...color);
  }

  /** A flat fill, the same from all sides. */
  triangle(corners: readonly [Vec3, Vec3, Vec3], color: Color): void {
    if (!corners.every(drawable)) return;
    for (const corner of corners) this.#triangles.push(...corner, 0, 0, 0, ...color);
  }

  /** An arrow as three lines: its head lies in the plane of the given side vector. */
  arrow(start: Vec3, vector: Vec3, side: Vec3, style: LineStyle): void {
    const end: Vec3 = [start[0] + vector[0], start[1] + vector[1], start[2] + vector[2]];
    this.line(start, end, style);
    for (const sign of [1, -1]) {
      const back = scale(vector, -0.18);
      const across = scale(side, 0.09 * sign);
      this.line(
        end,
        [end[0] + back[0] + across[0], end[1] + back[1] + across[1], end[2] + back[2] + across[2]],
        style,
      );
    }
  }
}

/** A diverging estimate may leave what single precision holds; the renderer would refuse the whole picture. */
const FARTHEST = 1e30;

function drawable(point: Vec3): boolean {
  return Math.abs(point[0]) < FARTHEST && Math.abs(point[1]) < FARTHEST && Math.abs(point[2]) < FARTHEST;
}
