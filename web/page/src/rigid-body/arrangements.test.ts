import { expect, test } from "vitest";
import { arrange, arrangementsIn, boxOf } from "./arrangements";

const box = boxOf([
  [0, 1, 2],
  [6, 5, 0],
  [3, 2, 1],
]);

test("the box holds all points", () => {
  expect(box).toEqual({ least: [0, 1, 0], most: [6, 5, 2] });
});

test("every arrangement stays in the box, with all coordinates", () => {
  for (const dimension of [2, 3]) {
    const inside = { least: box.least.slice(0, dimension), most: box.most.slice(0, dimension) };
    for (const arrangement of arrangementsIn(dimension))
      for (const count of [1, 2, 5]) {
        const points = arrange(arrangement, inside, count);
        if (arrangement !== "corners") expect(points).toHaveLength(count);
        for (const point of points) {
          expect(point).toHaveLength(dimension);
          point.forEach((value, axis) => {
            expect(value).toBeGreaterThanOrEqual(inside.least[axis]);
            expect(value).toBeLessThanOrEqual(inside.most[axis]);
          });
        }
      }
  }
});

test("corners are all different, a ceiling is level and on top, a line is straight", () => {
  expect(new Set(arrange("corners", box, 3).map(String)).size).toBe(8);
  expect(arrange("ceiling", box, 5).map((point) => point[2])).toEqual([2, 2, 2, 2, 2]);
  expect(arrange("line", box, 3)).toEqual([
    [0, 3, 1],
    [3, 3, 1],
    [6, 3, 1],
  ]);
});
