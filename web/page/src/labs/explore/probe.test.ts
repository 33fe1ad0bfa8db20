import { expect, test } from "vitest";
import type { FieldLayout } from "../../generated/FieldLayout";
import { pointUnder } from "./probe.svelte";

const field: FieldLayout = { corner: [-1, -2, 3], u: [4, 0, 0], v: [0, 5, 0], width: 4, height: 5 };
const down = (x: number, y: number) =>
  ({ origin: [x, y, 10], direction: [0, 0, -1] }) as Parameters<typeof pointUnder>[0];

test("a ray finds the point of the field that it meets", () => {
  expect(pointUnder(down(1, 1), field, 3)).toEqual([1, 1, 3]);
  expect(pointUnder(down(1, 1), { ...field, corner: [-1, -2, 0] }, 2)).toEqual([1, 1]);
});

test("beside the field, behind the eye and along the field there is none", () => {
  expect(pointUnder(down(3.1, 1), field, 3)).toBeNull();
  expect(pointUnder(down(1, -2.1), field, 3)).toBeNull();
  expect(pointUnder({ origin: [1, 1, 0], direction: [0, 0, -1] }, field, 3)).toBeNull();
  expect(pointUnder({ origin: [1, 1, 3], direction: [1, 0, 0] }, field, 3)).toBeNull();
});
