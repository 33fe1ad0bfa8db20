import { expect, test } from "vitest";
import type { Frame } from "../../scene/frame";
import { facesOf } from "./obstacles";

const space = {
  flat: false,
  ground: 0,
  whole: [
    [0, 0, 0],
    [9, 9, 3],
  ],
} as unknown as Frame;
const plane = { ...space, flat: true };
const wall = { kind: "wall" as const, from: [1, 2], to: [4, 2], bottom: null, top: null };

test("a wall without ends stands on the floor and is as high as the scene", () => {
  const [face] = facesOf(wall, space);
  expect(face.map(([, , z]) => z)).toEqual([0, 0, 3, 3]);
  const [window] = facesOf({ ...wall, bottom: 1, top: 2 }, space);
  expect(window.map(([, , z]) => z)).toEqual([1, 1, 2, 2]);
});

test("a box has six faces between its corners", () => {
  const faces = facesOf({ kind: "box", low: [1, 2, 0], high: [4, 3, 2] }, space);
  expect(faces).toHaveLength(6);
  const corners = new Set(faces.flat().map((corner) => corner.join()));
  expect(corners.size).toBe(8);
});

test("in the plane a wall is a line and a box a rectangle", () => {
  expect(facesOf(wall, plane)).toEqual([
    [
      [1, 2, 0],
      [4, 2, 0],
    ],
  ]);
  expect(facesOf({ kind: "box", low: [1, 2], high: [4, 3] }, plane)).toHaveLength(1);
});
