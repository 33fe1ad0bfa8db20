import { describe, expect, test } from "vitest";
import type { Thing } from "../state/things";
import type { Camera } from "./camera";
import { destination, startDrag } from "./drag";
import { add, type Vec3 } from "./geometry";
import { heightHandle, inside, type Pickable, pickAll } from "./picking";
import { View } from "./view";

const viewport = { width: 800, height: 600 };
const camera: Camera = { target: [0, 0, 0], yaw: -1, pitch: 0.5, distance: 20, orthographic: false };
const view = new View(camera, viewport);
const anchor: Vec3 = [2, -1, 1.5];

describe("dragging", () => {
  test("in the plane follows the pointer and keeps the height", () => {
    const goal: Vec3 = [-3, 2, 1.5];
    const follow = startDrag(view, anchor, view.project(anchor), "plane", 100);
    const moved = add(anchor, follow(view.project(goal), null));
    moved.forEach((value, axis) => expect(value).toBeCloseTo(goal[axis], 8));
  });

  test("up and down changes the height only", () => {
    const follow = startDrag(view, anchor, view.project(anchor), "height", 100);
    const shift = follow(view.project([2, -1, 4]), null);
    expect(shift.slice(0, 2)).toEqual([0, 0]);
    expect(shift[2]).toBeCloseTo(2.5, 8);
  });

  test("a grip beside the centre does not make the anchor jump", () => {
    const { x, y } = view.project(anchor);
    const grip = { x: x + 6, y: y - 4 };
    const shift = startDrag(view, anchor, grip, "plane", 100)(grip, null);
    shift.forEach((value) => expect(value).toBeCloseTo(0, 8));
  });

  test("snaps to multiples of the spacing, only along the axes that change", () => {
    const off: Vec3 = [2.3, -1.1, 1.37];
    const follow = startDrag(view, off, view.project(off), "plane", 100);
    const moved = add(off, follow(view.project([-2.9, 2.2, 1.37]), 0.5));
    [-3, 2, 1.37].forEach((value, axis) => expect(moved[axis]).toBeCloseTo(value, 9));
    const lift = startDrag(view, off, view.project(off), "height", 100);
    const lifted = add(off, lift(view.project([2.3, -1.1, 3.1]), 0.5));
    [2.3, -1.1, 3].forEach((value, axis) => expect(lifted[axis]).toBeCloseTo(value, 9));
  });

  test("seen edge-on the anchor moves in the plane that faces the viewer", () => {
    const level = new View({ ...camera, pitch: 0 }, viewport);
    const from = level.project(anchor);
    const shift = startDrag(level, anchor, from, "plane", 100)({ x: from.x, y: from.y - 50 }, null);
    expect(shift[2]).toBeGreaterThan(0.5);
    expect(shift[0]).toBeCloseTo(0, 6);
  });

  test("never leaves by more than the limit, not even at the horizon", () => {
    const from = view.project(anchor);
    const follow = startDrag(view, anchor, from, "plane", 30);
    for (let y = from.y; y > -400; y -= 20)
      expect(Math.hypot(...follow({ x: from.x, y }, null))).toBeLessThanOrEqual(30 + 1e-9);
  });

  test("a tap sends a thing to the place under it at its own height", () => {
    const goal: Vec3 = [-3, 2, 1.5];
    const place = destination(view, anchor, view.project(goal));
    goal.forEach((value, axis) => expect(place?.[axis]).toBeCloseTo(value, 8));
  });
});

describe("picking", () => {
  const things = new Map<Thing, Vec3>([
    [0, anchor],
    [1, [-3, 2, 0]],
    ["start", [1, 1, 0]],
  ]);
  const at = (thing: Thing, beside = 0) => {
    const { x, y } = view.project(things.get(thing)!);
    return { x: x + beside, y, touch: false };
  };
  const among = (points: Pickable["points"], last?: Thing): Pickable => ({
    points,
    last,
    lifted: points.get(last ?? -1) ?? null,
  });
  const found = (pickable: Pickable, pointer: ReturnType<typeof at>) =>
    pickAll(view, pickable, pointer).map(({ thing }) => thing);

  test("finds what is within reach, and nothing beyond", () => {
    expect(pickAll(view, among(things), at(1, 8))).toEqual([{ thing: 1, lifter: false }]);
    expect(found(among(things), at(1, 20))).toEqual([]);
    expect(found(among(things), { ...at(1, 20), touch: true })).toEqual([1]);
    expect(found(among(things), at("start"))).toEqual(["start"]);
  });

  test("the triangle lifts what was chosen last only", () => {
    const pointer = { ...view.project(heightHandle(view, anchor)), touch: false };
    expect(pickAll(view, among(things, 0), pointer)).toEqual([{ thing: 0, lifter: true }]);
    expect(pickAll(view, among(things, 1), pointer)).toEqual([]);
    expect(pickAll(view, { ...among(things, 0), lifted: null }, pointer)).toEqual([]);
  });

  test("a handle yields to an anchor at its place, but not once it is chosen", () => {
    const corner = new Map<Thing, Vec3>([["box low corner", anchor], ...things]);
    expect(found(among(corner), at(0, 3))).toEqual([0, "box low corner"]);
    expect(found(among(corner, "box low corner"), at(0, 3))).toEqual(["box low corner", 0]);
    expect(found(among(corner, 0), at(0, 3))).toEqual([0, "box low corner"]);
  });

  test("what is behind the viewer is not found", () => {
    const behind: Vec3 = [view.eye[0] * 2, view.eye[1] * 2, view.eye[2] * 2];
    const pointer = { ...view.project(behind), touch: false };
    expect(found(among(new Map([[0, behind]])), pointer)).toEqual([]);
  });

  test("a rectangle holds the things in it, whichever way it was drawn", () => {
    const { x, y } = at(1);
    const corners = [
      { x: x - 5, y: y - 5 },
      { x: x + 5, y: y + 5 },
    ] as const;
    expect(inside(view, things, corners[0], corners[1])).toEqual([1]);
    expect(inside(view, things, corners[1], corners[0])).toEqual([1]);
    expect(inside(view, things, { x: 0, y: 0 }, { x: 800, y: 600 })).toEqual([0, 1, "start"]);
  });
});
