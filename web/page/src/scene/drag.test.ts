import { describe, expect, test } from "vitest";
import { type Camera, View } from "./camera";
import { startDrag } from "./drag";
import type { Vec3 } from "./geometry";
import { heightHandle, pick } from "./picking";

const viewport = { width: 800, height: 600 };
const camera: Camera = { target: [0, 0, 0], yaw: -1, pitch: 0.5, distance: 20 };
const view = new View(camera, viewport);
const anchor: Vec3 = [2, -1, 1.5];

describe("dragging", () => {
  test("in the plane follows the pointer and keeps the height", () => {
    const goal: Vec3 = [-3, 2, 1.5];
    const from = view.project(anchor);
    const to = view.project(goal);
    const moved = startDrag(view, anchor, from, "plane", 100)(to.x, to.y);
    moved.forEach((value, axis) => expect(value).toBeCloseTo(goal[axis], 8));
  });

  test("up and down changes the height only", () => {
    const from = view.project(anchor);
    const to = view.project([2, -1, 4]);
    const moved = startDrag(view, anchor, from, "height", 100)(to.x, to.y);
    expect(moved[0]).toBe(2);
    expect(moved[1]).toBe(-1);
    expect(moved[2]).toBeCloseTo(4, 8);
  });

  test("a grip beside the centre does not make the anchor jump", () => {
    const { x, y } = view.project(anchor);
    const follow = startDrag(view, anchor, { x: x + 6, y: y - 4 }, "plane", 100);
    follow(x + 6, y - 4).forEach((value, axis) => expect(value).toBeCloseTo(anchor[axis], 8));
  });

  test("seen edge-on the anchor moves in the plane that faces the viewer", () => {
    const level = new View({ ...camera, pitch: 0 }, viewport);
    const from = level.project(anchor);
    const moved = startDrag(level, anchor, from, "plane", 100)(from.x, from.y - 50);
    expect(moved[2]).toBeGreaterThan(anchor[2] + 0.5);
    expect(moved[0]).toBeCloseTo(anchor[0], 6);
  });

  test("never leaves by more than the limit, not even at the horizon", () => {
    const from = view.project(anchor);
    const follow = startDrag(view, anchor, from, "plane", 30);
    for (let y = from.y; y > -400; y -= 20) {
      const moved = follow(from.x, y);
      expect(Math.hypot(moved[0] - 2, moved[1] + 1)).toBeLessThanOrEqual(30 + 1e-9);
    }
  });
});

describe("picking", () => {
  const anchors: Vec3[] = [anchor, [-3, 2, 0]];

  test("finds the nearest anchor within reach, and nothing beyond", () => {
    const { x, y } = view.project(anchors[1]);
    expect(pick(view, anchors, null, { x: x + 8, y, touch: false })).toEqual({ kind: "anchor", index: 1 });
    expect(pick(view, anchors, null, { x: x + 20, y, touch: false })).toBeNull();
    expect(pick(view, anchors, null, { x: x + 20, y, touch: true })).toEqual({ kind: "anchor", index: 1 });
  });

  test("offers the height handle of the selected anchor only", () => {
    const { x, y } = view.project(heightHandle(view, anchor));
    expect(pick(view, anchors, 0, { x, y, touch: false })).toEqual({ kind: "height", index: 0 });
    expect(pick(view, anchors, 1, { x, y, touch: false })).toBeNull();
  });

  test("does not find what is behind the viewer", () => {
    const behind: Vec3 = [view.eye[0] * 2, view.eye[1] * 2, view.eye[2] * 2];
    const { x, y } = view.project(behind);
    expect(pick(view, [behind], null, { x, y, touch: false })).toBeNull();
  });
});
