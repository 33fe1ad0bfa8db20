import type { View } from "./view";
import { type Color, type DrawList, STRIDE } from "./draw-list";
import { FieldCanvas } from "./field-canvas";
import { paintMark } from "./mark";
import type { ColouredField, Renderer } from "./renderer";

interface Item {
  readonly depth: number;
  readonly paint: (context: CanvasRenderingContext2D) => void;
}

/** Fills behind lines of the same depth; overlays last. Depths are distances, so this exceeds them all. */
const ALWAYS_IN_FRONT = -1;

/** The last resort: the same lists on a plain canvas, far things first. Works wherever a page works. */
export class Canvas2dRenderer implements Renderer {
  readonly backend = "canvas2d";
  readonly canvas = document.createElement("canvas");
  readonly #context: CanvasRenderingContext2D;
  readonly #field = new FieldCanvas();
  #scale = 1;

  constructor() {
    const context = this.canvas.getContext("2d");
    if (!context)
      throw new Error("This browser has no canvas: the scene cannot be drawn. The numbers still work.");
    this.#context = context;
  }

  resize(width: number, height: number): void {
    this.#context.canvas.width = width;
    this.#context.canvas.height = height;
  }

  draw(list: DrawList, view: View, background: Color, field: ColouredField | null): void {
    const context = this.#context;
    this.#scale = context.canvas.width / Math.max(1, view.viewport.width);
    context.fillStyle = css(background);
    context.fillRect(0, 0, context.canvas.width, context.canvas.height);
    if (field) this.#field.draw(context, field, view, this.#scale);
    const items = [
      ...this.#triangles(list.triangles, view),
      ...this.#ellipsoids(list.ellipsoids, view),
      ...this.#segments(list.segments, view),
      ...this.#points(list.points, view),
    ];
    items.sort((a, b) => b.depth - a.depth);
    for (const item of items) item.paint(context);
  }

  lost(): boolean {
    return false;
  }

  free(): void {
    this.#context.canvas.width = 0;
  }

  #pixel(view: View, v: Float32Array, at: number): Deep {
    const { x, y, depth } = view.project([v[at], v[at + 1], v[at + 2]]);
    return { x: x * this.#scale, y: y * this.#scale, depth };
  }

  /** Segments that continue each other are one line: painted once, and far fewer strokes. */
  #segments(values: Float32Array, view: View): Item[] {
    const items: Item[] = [];
    let line: Line | null = null;
    for (let at = 0; at < values.length; at += STRIDE.segment) {
      const ends = this.#visiblePart(view, values, at);
      if (!ends) {
        line = null;
        continue;
      }
      if (line && continues(values, at)) {
        line.points.push(ends[1]);
        continue;
      }
      line = startLine(values, at, ends);
      items.push(line);
    }
    return items;
  }

  /** The ends of a segment on the canvas, cut where it passes behind the viewer. */
  #visiblePart(view: View, values: Float32Array, at: number): [Deep, Deep] | null {
    const [a, b] = [this.#pixel(view, values, at), this.#pixel(view, values, at + 3)];
    const near = view.camera.distance / 100;
    if (a.depth < near && b.depth < near) return null;
    if (a.depth >= near && b.depth >= near) return [a, b];
    const share = (near - a.depth) / (b.depth - a.depth);
    const cut = Float32Array.from(
      [0, 1, 2],
      (i) => values[at + i] + share * (values[at + 3 + i] - values[at + i]),
    );
    const edge = this.#pixel(view, cut, 0);
    return a.depth < near ? [edge, b] : [a, edge];
  }

  #points(values: Float32Array, view: View): Item[] {
    const items: Item[] = [];
    for (let at = 0; at < values.length; at += STRIDE.point) {
      const centre = this.#pixel(view, values, at);
      if (centre.depth <= 0) continue;
      const radius = values[at + 3];
      const color = css([values[at + 4], values[at + 5], values[at + 6], values[at + 7]]);
      const shape = values[at + 8];
      items.push({
        depth: centre.depth,
        paint: (context) => paintMark(context, centre, radius, shape, color),
      });
    }
    return items;
  }

  /** The outline of an ellipsoid is, near enough, the ellipse of the projected semi-axes. */
  #ellipsoids(values: Float32Array, view: View): Item[] {
    const items: Item[] = [];
    for (let at = 0; at < values.length; at += STRIDE.ellipsoid) {
      const centre = this.#pixel(view, values, at);
      if (centre.depth <= 0) continue;
      const axes = [3, 6, 9].map((offset) => {
        const tip = [0, 1, 2].map((i) => values[at + i] + values[at + offset + i]);
        const end = this.#pixel(view, Float32Array.from(tip), 0);
        return { x: end.x - centre.x, y: end.y - centre.y };
      });
      const color: Color = [values[at + 12], values[at + 13], values[at + 14], values[at + 15]];
      items.push({ depth: centre.depth, paint: (context) => paintEllipse(context, centre, axes, color) });
    }
    return items;
  }

  #triangles(values: Float32Array, view: View): Item[] {
    const items: Item[] = [];
    const size = 3 * STRIDE.vertex;
    for (let at = 0; at < values.length; at += size) {
      const corners = [0, 1, 2].map((corner) => this.#pixel(view, values, at + corner * STRIDE.vertex));
      if (corners.some((corner) => corner.depth <= 0)) continue;
      const color = css([values[at + 6], values[at + 7], values[at + 8], values[at + 9]]);
      const depth = Math.max(...corners.map((corner) => corner.depth));
      items.push({ depth, paint: (context) => paintPolygon(context, corners, color) });
    }
    return items;
  }
}

interface Pixel {
  readonly x: number;
  readonly y: number;
}

interface Deep extends Pixel {
  readonly depth: number;
}

interface Line extends Item {
  readonly points: Deep[];
}

/** Whether the segment starts where the one before it ends and looks the same. */
function continues(values: Float32Array, at: number): boolean {
  const before = at - STRIDE.segment;
  for (let i = 0; i < 3; i++) if (values[at + i] !== values[before + 3 + i]) return false;
  for (let i = 6; i < STRIDE.segment; i++) if (values[at + i] !== values[before + i]) return false;
  return true;
}

function startLine(values: Float32Array, at: number, ends: readonly [Deep, Deep]): Line {
  const [width, dash] = [values[at + 6], values[at + 7]];
  const color = css([values[at + 8], values[at + 9], values[at + 10], values[at + 11]]);
  const points = [...ends];
  return {
    points,
    depth: values[at + 12] > 0 ? ALWAYS_IN_FRONT : (ends[0].depth + ends[1].depth) / 2,
    paint: (context) => {
      context.strokeStyle = color;
      context.lineWidth = width;
      context.lineJoin = "round";
      context.setLineDash(dash > 0 ? [dash, dash] : []);
      context.beginPath();
      for (const point of points) context.lineTo(point.x, point.y);
      context.stroke();
    },
  };
}

function paintPolygon(context: CanvasRenderingContext2D, corners: readonly Pixel[], color: string): void {
  context.fillStyle = color;
  context.beginPath();
  for (const corner of corners) context.lineTo(corner.x, corner.y);
  context.fill();
}

function paintEllipse(context: CanvasRenderingContext2D, centre: Pixel, axes: Pixel[], color: Color): void {
  const sum = (pick: (axis: Pixel) => number) => axes.reduce((total, axis) => total + pick(axis), 0);
  const [xx, xy, yy] = [sum((a) => a.x * a.x), sum((a) => a.x * a.y), sum((a) => a.y * a.y)];
  const middle = (xx + yy) / 2;
  const spread = Math.hypot((xx - yy) / 2, xy);
  context.beginPath();
  const small = Math.sqrt(Math.max(0, middle - spread));
  context.ellipse(
    centre.x,
    centre.y,
    Math.sqrt(middle + spread),
    small,
    Math.atan2(2 * xy, xx - yy) / 2,
    0,
    2 * Math.PI,
  );
  context.fillStyle = css(color);
  context.fill();
  context.setLineDash([]);
  context.lineWidth = 1.5;
  context.strokeStyle = css([color[0], color[1], color[2], Math.min(1, color[3] * 3)]);
  context.stroke();
}

function css([r, g, b, a]: Color): string {
  return `rgb(${Math.round(r * 255)} ${Math.round(g * 255)} ${Math.round(b * 255)} / ${a})`;
}
