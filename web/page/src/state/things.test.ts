import { expect, test } from "vitest";
import { rigidBody } from "../rigid-body/family";
import type { Scenario } from "../scenario";
import type { Handle } from "./handles";
import { existing, middleOf, moveSentence, nameOf, placeOf, putAt, type Thing } from "./things";

const scenario = {
  dimension: 3,
  anchors: [
    [0, 0, 0],
    [4, 0, 2],
  ],
  start: { position: [1, 1, 1], orientation: [] },
  redraw_anchors: null,
  sensors: [],
  availability: { max_ranges: [] },
  placement: { fixed: [] },
  lamp: [2, 3],
} as unknown as Scenario;

type WithLamp = Scenario & { lamp: readonly number[] };
/** Stays left of x = 5. */
const lab = {
  family: rigidBody,
  handles: (of: Scenario): Handle<Scenario>[] => [
    {
      id: "lamp",
      name: "Lamp",
      place: (of as WithLamp).lamp,
      mark: "square",
      token: "accent",
      move: (next, [x, y]) => ({ ...next, lamp: [Math.min(x, 5), y] }) as Scenario,
    },
  ],
};
const things = { scenario, lab };
const after = (places: [Thing, number[]][]) => ({ scenario: putAt(things, new Map(places)), lab });

test("anchors, the start and a lab's handles have places and go where they are put", () => {
  expect([0, "start", "lamp"].map((thing) => placeOf(things, thing))).toEqual([
    [0, 0, 0],
    [1, 1, 1],
    [2, 3],
  ]);
  const moved = after([
    [1, [9, 9, 9]],
    ["start", [2, 2, 2]],
    ["lamp", [4, 4]],
  ]);
  expect([0, 1, "start", "lamp"].map((thing) => placeOf(moved, thing))).toEqual([
    [0, 0, 0],
    [9, 9, 9],
    [2, 2, 2],
    [4, 4],
  ]);
});

test("a sentence tells where a thing is, not where it was sent", () => {
  expect(moveSentence(after([["lamp", [9, 1]]]), ["lamp"])).toBe("Lamp moved to (5, 1) m");
  expect(moveSentence(things, [0, "lamp"])).toBe("Anchor 1 and lamp moved, now around (1, 1.5, 0) m");
});

test("things are named by what they are", () => {
  expect(nameOf(things, [0, 1])).toBe("2 anchors");
  expect(nameOf(things, ["start"])).toBe("Start of the body");
  expect(nameOf(things, [1, "start", "lamp"])).toBe("Anchor 2 and 2 handles");
});

test("the middle of things has a height where one of them has", () => {
  expect(
    middleOf([
      [0, 0, 3],
      [2, 4],
    ]),
  ).toEqual([1, 2, 3]);
  expect(
    middleOf([
      [0, 0],
      [2, 4],
    ]),
  ).toEqual([1, 2]);
});

test("what another lab or an older scenario has is not chosen any more", () => {
  const chosen = [1, "lamp", "start"];
  expect(existing(things, chosen)).toBe(chosen);
  expect(existing({ scenario, lab: { family: rigidBody } }, [...chosen, 7])).toEqual([1, "start"]);
});
