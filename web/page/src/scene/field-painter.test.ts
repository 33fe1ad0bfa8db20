import { expect, test } from "vitest";
import type { FieldColours } from "../theme/field-colours";
import { type FieldPicture, pointOfField } from "./field";
import { FIELD_BLOCK, FieldPainter, type PaintedField } from "./field-painter";
import { View } from "./view";

const above = {
  target: [0, 0, 0],
  yaw: -Math.PI / 2,
  pitch: Math.PI / 2,
  distance: 20,
  orthographic: true,
} as const;
const view = new View(above, { width: 400, height: 300 });
const colours: FieldColours = {
  stops: [
    [0, 0, 0],
    [1, 0, 0],
  ],
  hatch: [0, 1, 0],
  noBound: [0, 0, 1],
};
const picture: FieldPicture = {
  values: Float32Array.of(1, 10, 100, 1, 10, 1e30),
  width: 3,
  height: 2,
  corner: [-3, -2, 0],
  u: [6, 0, 0],
  v: [0, 4, 0],
  low: 1,
  high: 100,
  worseThan: null,
  opacity: 0.5,
};

function paint(changes: Partial<FieldPicture> = {}): PaintedField {
  return new FieldPainter({ picture: { ...picture, ...changes }, colours }).paint(view)!;
}

/** Red, green, blue, alpha of the block at (s, t) of the rectangle. */
function colourOf(painted: PaintedField, s: number, t: number): number[] {
  const { x, y } = view.project(pointOfField(picture, s, t));
  const column = Math.floor(x / FIELD_BLOCK) - painted.left;
  const row = Math.floor(y / FIELD_BLOCK) - painted.top;
  const bytes = new Uint8Array(painted.pixels.buffer);
  return [...bytes.subarray(4 * (row * painted.width + column)).subarray(0, 4)];
}

/** All colours of a cell. */
function coloursOf(painted: PaintedField, column: number, row: number): number[][] {
  const within = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];
  return within.flatMap((s) =>
    within.map((t) => colourOf(painted, (column + s) / picture.width, (row + t) / picture.height)),
  );
}

test("the middles of cells have the colours of their numbers, on a logarithmic scale", () => {
  const painted = paint();
  const red = [0, 1, 2].map((column) => colourOf(painted, (column + 0.5) / 3, 0.25)[0]);
  expect(Math.abs(red[0] - 0)).toBeLessThan(6);
  expect(Math.abs(red[1] - 127)).toBeLessThan(6);
  expect(Math.abs(red[2] - 255)).toBeLessThan(6);
  expect(Math.abs(colourOf(painted, 1 / 3, 0.25)[0] - 64)).toBeLessThan(6);
});

test("a cell without a bound is cross-hatched in its own colour, as sharp as the cell", () => {
  const painted = paint();
  const there = coloursOf(painted, 2, 1);
  expect(there.every(([r, g, b]) => r === 0 && Math.abs(g + b - 255) <= 1)).toBe(true);
  expect(new Set(there.map(([, green]) => green)).size).toBeGreaterThan(2);
  expect(coloursOf(painted, 0, 1).every(([, g, b]) => g === 0 && b === 0)).toBe(true);
});

test("only numbers above the limit are hatched", () => {
  const painted = paint({ worseThan: 60, values: Float32Array.of(1, 10, 100, 1, 10, 100) });
  const green = (column: number) => new Set(coloursOf(painted, column, 0).map((colour) => colour[1]));
  expect([...green(0)]).toEqual([0]);
  expect(green(2).size).toBeGreaterThan(2);
});

test("nothing is painted beside the rectangle", () => {
  const tilted = { u: [5, 2, 0], v: [-2, 4, 0] } as const;
  const painted = paint(tilted);
  const bytes = new Uint8Array(painted.pixels.buffer);
  const covered = bytes.filter((_, i) => i % 4 === 3 && bytes[i] === 255).length;
  const block = (FIELD_BLOCK * view.metresPerPixel([0, 0, 0])) ** 2;
  // The area of the parallelogram: 5 * 4 + 2 * 2 square metres.
  expect((covered * block) / 24).toBeCloseTo(1, 2);
});

test("what is seen edge-on or not at all is not painted", () => {
  const painter = new FieldPainter({ picture, colours });
  expect(painter.paint(new View({ ...above, pitch: 0 }, view.viewport))).toBeNull();
  expect(painter.paint(new View({ ...above, target: [500, 0, 0] }, view.viewport))).toBeNull();
});
