import { expect, test } from "vitest";
import { arrange } from "./layout";

test("four plots stand in a row where the room is low, two by two where it is high", () => {
  expect(arrange(4, 1080, 180, 15)).toEqual({ columns: 4, count: 4 });
  expect(arrange(4, 1080, 420, 15)).toEqual({ columns: 2, count: 4 });
});

test("where room is short, fewer are shown", () => {
  expect(arrange(4, 700, 170, 14)).toEqual({ columns: 3, count: 3 });
  expect(arrange(4, 100, 20, 18)).toEqual({ columns: 1, count: 1 });
});

test("one plot has all the room", () => {
  expect(arrange(1, 1080, 420, 15)).toEqual({ columns: 1, count: 1 });
});
