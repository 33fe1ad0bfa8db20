import { expect, test } from "vitest";
import { type Color, DrawList, STRIDE } from "./draw-list";
import type { Vec3 } from "./geometry";

const red: Color = [1, 0, 0, 0.5];

test("a line is thirteen numbers in physical pixels", () => {
  const list = new DrawList();
  list.pixelRatio = 2;
  list.weight = 1.5;
  list.line([1, 2, 3], [4, 5, 6], { width: 2, color: red, dash: 3, overlay: true });
  expect([...list.segments]).toEqual([1, 2, 3, 4, 5, 6, 6, 6, 1, 0, 0, 0.5, 1]);
});

test("points, ellipsoids and triangles keep their layouts", () => {
  const list = new DrawList();
  list.point([1, 2, 3], 4, red, "diamond");
  expect([...list.points]).toEqual([1, 2, 3, 4, 1, 0, 0, 0.5, 4]);
  list.ellipsoid(
    [0, 0, 0],
    [
      [1, 0, 0],
      [0, 2, 0],
      [0, 0, 3],
    ],
    red,
  );
  expect(list.ellipsoids).toHaveLength(STRIDE.ellipsoid);
  list.triangle(
    [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ],
    red,
  );
  expect(list.triangles).toHaveLength(3 * STRIDE.vertex);
});

test("grows beyond its first size and is empty after clearing", () => {
  const list = new DrawList();
  for (let i = 0; i < 1000; i++) list.line([i, 0, 0], [i, 1, 0], { width: 1, color: red });
  expect(list.segments).toHaveLength(1000 * STRIDE.segment);
  expect(list.segments[999 * STRIDE.segment]).toBe(999);
  list.clear();
  expect(list.segments).toHaveLength(0);
});

test("leaves out what cannot be drawn instead of losing the picture", () => {
  const list = new DrawList();
  list.line([0, 0, 0], [Infinity, 0, 0], { width: 1, color: red });
  list.point([NaN, 0, 0], 3, red, "disc");
  list.ellipsoid(
    [0, 0, 0],
    [
      [1e39, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ],
    red,
  );
  expect([list.segments.length, list.points.length, list.ellipsoids.length]).toEqual([0, 0, 0]);
});

test("a path is the same lines, without those that cannot be drawn", () => {
  const [list, lines] = [new DrawList(), new DrawList()];
  const points: Vec3[] = [
    [0, 0, 0],
    [1, 0, 0],
    [1, 2, 0],
    [NaN, 0, 0],
    [1, 2, 3],
    [2, 2, 3],
  ];
  const style = { width: 2, color: red, dash: 3 };
  list.path(Float32Array.from(points.flat()), 1, 5, style);
  lines.polyline(points.slice(1), style);
  expect([...list.segments]).toEqual([...lines.segments]);
  expect(list.segments).toHaveLength(2 * STRIDE.segment);
});
