import { describe, expect, test } from "vitest";
import { axisOfKey, bodyView, directionOf, reachOf, shiftOf, SIDES, sideOf } from "./body-view";

const viewport = { width: 300, height: 200 };

describe("how far one sees", () => {
  test("holds the whole body", () => {
    for (const radius of [0.01, 0.1, 0.13, 1, 7]) {
      const reach = reachOf([[radius, 0, 0]]);
      expect(reach).toBeGreaterThan(1.2 * radius);
      expect(reach).toBeLessThan(1.8 * radius);
      const { x } = bodyView(directionOf("top"), reach, viewport).project([radius, 0, 0]);
      expect(x).toBeLessThan(viewport.width);
    }
  });

  test("does not change with small changes of the body, nor is it nothing for a single sensor at the origin", () => {
    expect(reachOf([[0.31, 0, 0]])).toBe(reachOf([[0.34, 0, 0]]));
    expect(reachOf([[0, 0, 0]])).toBeGreaterThan(0);
  });
});

describe("a drag in the view plane", () => {
  test.each(["space", "front", "side", "top", "plane"] as const)("follows the pointer: %s", (side) => {
    const view = bodyView(directionOf(side), 0.5, viewport);
    const from = view.project([0.1, -0.05, 0.2]);
    const to = { x: from.x + 37, y: from.y - 21 };
    const [dx, dy, dz] = shiftOf(view, from, to);
    const moved = view.project([0.1 + dx, -0.05 + dy, 0.2 + dz]);
    expect(moved.x).toBeCloseTo(to.x, 6);
    expect(moved.y).toBeCloseTo(to.y, 6);
    expect(moved.depth).toBeCloseTo(from.depth, 9);
  });

  test("seen along an axis leaves that coordinate alone", () => {
    const unseen = { front: 1, side: 0, top: 2 };
    for (const side of SIDES) {
      const view = bodyView(directionOf(side), 0.5, viewport);
      const shift = shiftOf(view, { x: 0, y: 0 }, { x: 30, y: 40 });
      expect(Math.abs(shift[unseen[side]])).toBeLessThan(1e-15);
    }
  });
});

test("a turned view is none of the sides", () => {
  for (const side of SIDES) expect(sideOf(directionOf(side))).toBe(side);
  expect(sideOf({ ...directionOf("front"), yaw: 0.3 })).toBeNull();
  expect(sideOf(directionOf("space"))).toBeNull();
});

describe("arrow keys", () => {
  const moves = (side: Parameters<typeof directionOf>[0], dimension: number) =>
    ["ArrowRight", "ArrowUp", "PageUp"].map((key) => {
      const move = axisOfKey(key, directionOf(side), dimension);
      return move && `${move.sign > 0 ? "+" : "-"}${"xyz"[move.axis]}`;
    });

  test("move along the axes as they lie in the view", () => {
    expect(moves("front", 3)).toEqual(["+x", "+z", "-y"]);
    expect(moves("side", 3)).toEqual(["+y", "+z", "+x"]);
    expect(moves("top", 3)).toEqual(["+x", "+y", "+z"]);
    expect(moves("space", 3)).toEqual(["+x", "+z", "-y"]);
    expect(moves("plane", 2)).toEqual(["+x", "+y", null]);
  });

  test("reach every coordinate from wherever one looks, and back", () => {
    for (let yaw = 0; yaw < 6.3; yaw += 0.37)
      for (let pitch = -1.5; pitch < 1.6; pitch += 0.43) {
        const direction = { yaw, pitch, orthographic: true };
        const keys = ["ArrowRight", "ArrowUp", "PageUp"].map((key) => axisOfKey(key, direction, 3)?.axis);
        expect(new Set(keys)).toEqual(new Set([0, 1, 2]));
        expect(axisOfKey("ArrowLeft", direction, 3)?.sign).toBe(
          -(axisOfKey("ArrowRight", direction, 3)?.sign ?? 0),
        );
      }
  });

  test("are the only ones", () => {
    expect(axisOfKey("x", directionOf("top"), 3)).toBeNull();
  });
});
