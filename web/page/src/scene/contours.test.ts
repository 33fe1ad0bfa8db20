import { describe, expect, test } from "vitest";
import { contourLines, fieldContourLabels, fieldContours } from "./contours";
import { type Color, DrawList, STRIDE } from "./draw-list";
import { type FieldPicture, pointOfField, UNBOUNDED } from "./field";
import { length, sub, type Vec3 } from "./geometry";
import type { SceneInput } from "./input";

const [width, height] = [80, 60];
/** A tilted rectangle whose unit edges are perpendicular: 8 m by 6 m. */
const rectangle = { corner: [1, -2, 3] as Vec3, u: [0, 8, 0] as Vec3, v: [-4.8, 0, 3.6] as Vec3 };
const cell = 0.1;

function field(value: (x: number, y: number) => number, low: number, high: number): FieldPicture {
  const values = Float32Array.from({ length: width * height }, (_, k) =>
    value(((k % width) + 0.5) * cell, (Math.floor(k / width) + 0.5) * cell),
  );
  return { values, width, height, ...rectangle, low, high, worseThan: null, opacity: 1 };
}

const pointsOf = (points: Float32Array): Vec3[] =>
  Array.from({ length: points.length / 3 }, (_, i) => [points[3 * i], points[3 * i + 1], points[3 * i + 2]]);

/** Numbers that grow with the distance from (4, 3) m: their contours are circles. */
const radius = (x: number, y: number) => Math.hypot(x - 4, y - 3);
const middle = (picture: FieldPicture) => pointOfField(picture, 0.5, 0.5);

describe("contours of a cone", () => {
  const picture = field(radius, 0.15, 2.9);
  const lines = contourLines(picture);

  test("are one closed circle for each of 0.2, 0.5, 1, 2", () => {
    expect(lines.map(({ level }) => level)).toEqual([0.2, 0.5, 1, 2]);
    for (const { points } of lines) expect([...points.slice(0, 3)]).toEqual([...points.slice(-3)]);
  });

  test("have the radius that is their level, within a fifth of a cell", () => {
    for (const { level, points } of lines.slice(1)) {
      const distances = pointsOf(points).map((point) => length(sub(point, middle(picture))));
      expect(Math.max(...distances.map((distance) => Math.abs(distance - level)))).toBeLessThan(cell / 5);
    }
  });

  test("are found once for each field and unit", () => {
    expect(contourLines(picture)).toBe(lines);
    expect(contourLines(picture, 100)).not.toBe(lines);
    expect(contourLines(picture, 100).map(({ level }) => level)).toEqual([20, 50, 100, 200]);
  });
});

test("levels are round in the unit that is shown", () => {
  const degrees = 180 / Math.PI;
  const picture = field((x, y) => radius(x, y) / degrees, 0.15 / degrees, 2.9 / degrees);
  expect(contourLines(picture, degrees).map(({ level }) => level)).toEqual([0.2, 0.5, 1, 2]);
});

test("lines that leave the grid stay open and do not run along its border", () => {
  // Its logarithm, between whose numbers the lines are interpolated, is linear.
  const picture = field((x) => 10 ** (x / 4), 0.5, 99);
  const lines = contourLines(picture);
  expect(lines.map(({ level }) => level)).toEqual([2, 5, 10, 20, 50]);
  for (const { level, points } of lines) {
    const along = pointsOf(points);
    for (const point of along) expect(point[1] - rectangle.corner[1]).toBeCloseTo(4 * Math.log10(level), 4);
    expect(length(sub(along[0], along.at(-1)!))).toBeCloseTo(6 - cell, 3);
  }
});

test("a line ends where no bound exists, and none runs around such a place", () => {
  const hole = (x: number, y: number) => x > 6 && y > 2 && y < 4;
  const picture = field((x, y) => (hole(x, y) ? UNBOUNDED : radius(x, y)), 0.15, 2.9);
  const [circle, ...others] = contourLines(picture).filter(({ level }) => level === 2);
  expect(contourLines(picture)).toHaveLength(4);
  expect(others).toEqual([]);
  const along = pointsOf(circle.points);
  for (const point of along) expect(Math.abs(length(sub(point, middle(picture))) - 2)).toBeLessThan(cell / 5);
  const whole = contourLines(field(radius, 0.15, 2.9)).at(-1)!;
  expect(circle.points.length).toBeLessThan(whole.points.length);
  const gap = length(sub(along[0], along.at(-1)!));
  expect(gap).toBeGreaterThan(cell);
});

test("no bound anywhere has no line, and no number outside the scale has one", () => {
  expect(contourLines(field(() => UNBOUNDED, 0.1, 1))).toEqual([]);
  expect(contourLines(field(() => 3, 0.1, 1))).toEqual([]);
});

test("labels say level and unit and lie on their lines; short lines have none", () => {
  const picture = field(radius, 0.15, 2.9);
  const labels = fieldContourLabels(picture, 100, "cm");
  expect(labels.map(({ text }) => text)).toEqual(["50 cm", "100 cm", "200 cm"].slice(-labels.length));
  expect(labels.length).toBeGreaterThanOrEqual(2);
  for (const { at, text } of labels)
    expect(100 * length(sub(at, middle(picture)))).toBeCloseTo(parseFloat(text), -1);
  expect(new Set(labels.map(({ id }) => id)).size).toBe(labels.length);
});

test("the layer draws every line", () => {
  const picture = field(radius, 0.15, 2.9);
  const out = new DrawList();
  const ink: Color = [0, 0, 0, 1];
  fieldContours({ palette: { rgba: () => ink } } as unknown as SceneInput, out, picture);
  const segments = contourLines(picture).reduce((sum, { points }) => sum + points.length / 3 - 1, 0);
  expect(out.segments).toHaveLength(segments * STRIDE.segment);
});
