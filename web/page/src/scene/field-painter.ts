import { colourAt, type FieldColours, mix, type Rgb } from "../theme/field-colours";
import { type FieldPicture, placeOnScale, pointOfField, UNBOUNDED } from "./field";
import { fieldFromPixel } from "./field-plane";
import type { ColouredField } from "./renderer";
import type { View } from "./view";

/** CSS pixels along the edge of a block that gets one colour. */
export const FIELD_BLOCK = 2;
/** Colours along the scale, and kinds of hatching from none to full. */
const RAMP = 256;
const HATCHED = 4;

/** Blocks of colour to be drawn with the picture's opacity: the upper left one has its corner at (left, top) blocks. */
export interface PaintedField {
  /** A number a pixel, bytes red, green, blue, alpha: a field covers it or not. */
  readonly pixels: Uint32Array<ArrayBuffer>;
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** The numbers of one field as places on the scale and colours, made once and looked up for each view. */
export class FieldPainter {
  readonly #picture: FieldPicture;
  readonly #places: Float32Array;
  readonly #worse: number;
  readonly #ramp: Uint32Array;
  readonly #noBound: Uint32Array;

  constructor({ picture, colours }: ColouredField) {
    this.#picture = picture;
    this.#places = paddedPlaces(picture);
    this.#worse =
      picture.worseThan === null ? Infinity : placeOnScale(picture.worseThan, picture) * (RAMP - 1);
    this.#ramp = rampOf(colours);
    this.#noBound = Uint32Array.from({ length: HATCHED + 1 }, (_, i) =>
      packed(mix(colours.noBound, colours.hatch, i / HATCHED)),
    );
  }

  /** The colour of each block whose middle sees the rectangle; null where none does. */
  paint(view: View): PaintedField | null {
    const back = fieldFromPixel(view, this.#picture);
    const box = back && boxOf(view, this.#picture);
    if (!back || !box || box.width <= 0 || box.height <= 0) return null;
    const pixels = new Uint32Array(box.width * box.height);
    const [[sx, sy, s1], [tx, ty, t1], [wx, wy, w1]] = back;
    const middle = view.project(pointOfField(this.#picture, 0.5, 0.5));
    for (let row = 0, at = 0; row < box.height; row++) {
      const y = (box.top + row + 0.5) * FIELD_BLOCK;
      for (let column = 0; column < box.width; column++, at++) {
        const x = (box.left + column + 0.5) * FIELD_BLOCK;
        const w = wx * x + wy * y + w1;
        const s = (sx * x + sy * y + s1) / w;
        const t = (tx * x + ty * y + t1) / w;
        if (w > 0 && s >= 0 && s <= 1 && t >= 0 && t <= 1)
          pixels[at] = this.#colour(s, t, x - middle.x, y - middle.y);
      }
    }
    return { pixels, ...box };
  }

  /** The hatching moves with the middle of the rectangle, from which (x, y) are CSS pixels. */
  #colour(s: number, t: number, x: number, y: number): number {
    const place = this.#placeAt(s, t);
    if (Number.isNaN(place)) return this.#noBound[Math.max(lines(x + y), lines(x - y))];
    const index = place <= 0 ? 0 : place >= RAMP - 1 ? RAMP - 1 : (place + 0.5) | 0;
    return this.#ramp[(place > this.#worse ? lines(x + y) : 0) * RAMP + index];
  }

  /** Interpolated between the middles of four cells; that of the cell there if one of the four has no bound. */
  #placeAt(s: number, t: number): number {
    const places = this.#places;
    const { width, height } = this.#picture;
    const x = s * width + 0.5;
    const y = t * height + 0.5;
    const column = x | 0;
    const row = y | 0;
    const at = row * (width + 2) + column;
    const below = at + width + 2;
    const p = x - column;
    const q = y - row;
    const upper = places[at] + (places[at + 1] - places[at]) * p;
    const lower = places[below] + (places[below + 1] - places[below]) * p;
    const place = upper + (lower - upper) * q;
    return Number.isNaN(place) ? places[(q < 0.5 ? at : below) + (p < 0.5 ? 0 : 1)] : place;
  }
}

/** Places of the numbers on the ramp, not a number where no bound exists, with the cells on the edges once more around. */
function paddedPlaces(picture: FieldPicture): Float32Array {
  const { values, width, height } = picture;
  const places = values.map((value) => (value < UNBOUNDED ? placeOnScale(value, picture) * (RAMP - 1) : NaN));
  const padded = new Float32Array((width + 2) * (height + 2));
  for (let row = 0; row < height + 2; row++) {
    const from = Math.min(height - 1, Math.max(0, row - 1)) * width;
    const to = row * (width + 2);
    padded.set(places.subarray(from, from + width), to + 1);
    padded[to] = places[from];
    padded[to + width + 1] = places[from + width - 1];
  }
  return padded;
}

/** How much of a block is covered by lines of 1.5 pixels, 10 pixels apart, in 0..HATCHED. */
function lines(across: number): number {
  const turns = across * 0.0707;
  const distance = 10 * Math.abs(turns - Math.floor(turns) - 0.5);
  const cover = 0.5 + (0.75 - distance) / FIELD_BLOCK;
  return cover <= 0 ? 0 : cover >= 1 ? HATCHED : Math.round(cover * HATCHED);
}

function rampOf(colours: FieldColours): Uint32Array {
  return Uint32Array.from({ length: (HATCHED + 1) * RAMP }, (_, i) => {
    const colour = colourAt(colours, (i % RAMP) / (RAMP - 1));
    return packed(mix(colour, colours.hatch, Math.floor(i / RAMP) / HATCHED));
  });
}

function packed(colour: Rgb): number {
  const [r, g, b] = colour.map((part) => Math.round(part * 255));
  return new Uint32Array(Uint8Array.of(r, g, b, 255).buffer)[0];
}

/** The blocks of the canvas around the rectangle: all of them where a part of it is behind the viewer. */
function boxOf(view: View, picture: FieldPicture): Omit<PaintedField, "pixels"> {
  const corners = [
    [0, 0],
    [1, 0],
    [0, 1],
    [1, 1],
  ].map(([s, t]) => view.project(pointOfField(picture, s, t)));
  const whole = corners.some(({ depth }) => depth <= 0);
  const range = (along: "x" | "y", size: number): [number, number] => {
    const seen = whole ? [0, size] : corners.map((corner) => Math.min(size, Math.max(0, corner[along])));
    return [Math.floor(Math.min(...seen) / FIELD_BLOCK), Math.ceil(Math.max(...seen) / FIELD_BLOCK)];
  };
  const [left, right] = range("x", view.viewport.width);
  const [top, bottom] = range("y", view.viewport.height);
  return { left, top, width: right - left, height: bottom - top };
}
