import { describe, expect, test } from "vitest";
import { type Camera, DIRECTIONS, limit, orbit, pan, zoom, zoomTo } from "./camera";
import { fit } from "./fit";
import type { Frame } from "./frame";
import type { Vec3 } from "./geometry";
import { between } from "./transition";
import { View } from "./view";

const viewport = { width: 800, height: 600 };
const camera: Camera = { target: [1, -2, 0.5], yaw: 0.7, pitch: 0.4, distance: 12, orthographic: false };
const above: Camera = { ...camera, ...DIRECTIONS.plane };
const points: Vec3[] = [
  [3, 1, 0],
  [-2, -4, 2],
  [1, -2, 0.5],
];

describe("View", () => {
  test("puts the target in the middle at its distance", () => {
    const { x, y, depth } = new View(camera, viewport).project(camera.target);
    expect([x, y, depth].map((value) => Number(value.toFixed(9)))).toEqual([400, 300, 12]);
  });

  test.each([camera, above])("the ray through a projected point goes through the point", (from) => {
    const view = new View(from, viewport);
    for (const point of points) {
      const { origin, direction } = view.ray(view.project(point));
      const along = Math.hypot(point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]);
      point.forEach((value, axis) => expect(origin[axis] + along * direction[axis]).toBeCloseTo(value, 8));
    }
  });

  test("z is up and depth lies in 0..1 of clip space", () => {
    const view = new View(camera, viewport);
    const [low, high] = [view.project([1, -2, 0]), view.project([1, -2, 2])];
    expect(high.y).toBeLessThan(low.y);
    const m = view.matrix;
    const [x, y, z] = camera.target;
    const clipZ = m[2] * x + m[6] * y + m[10] * z + m[14];
    const clipW = m[3] * x + m[7] * y + m[11] * z + m[15];
    expect(clipZ / clipW).toBeGreaterThan(0);
    expect(clipZ / clipW).toBeLessThan(1);
  });

  test("a pixel at a depth is as wide as it says", () => {
    const view = new View(camera, viewport);
    const size = view.metresPerPixel(camera.target);
    const above = view.project([1, -2, 0.5 + size * 10]);
    expect(300 - above.y).toBeCloseTo(10 * Math.cos(camera.pitch), 1);
  });

  test("an orthographic view has the same scale at every depth, that of the target", () => {
    const view = new View(above, viewport);
    const pixels = (z: number) => view.project([2, -2, z]).x - view.project([1, -2, z]).x;
    expect(pixels(3)).toBeCloseTo(pixels(-3), 9);
    expect(pixels(0.5) * view.metresPerPixel([7, 7, 7])).toBeCloseTo(1, 9);
    expect(view.metresPerPixel([0, 0, 0])).toBeCloseTo(
      new View(camera, viewport).metresPerPixel(camera.target),
      12,
    );
  });

  test("a pixel meets a level plane, or never above the horizon", () => {
    const view = new View(camera, viewport);
    const hit = view.onLevel(view.project([3, 1, 0]), 0);
    [3, 1, 0].forEach((value, axis) => expect(hit?.[axis]).toBeCloseTo(value, 8));
    expect(view.onLevel({ x: 400, y: -2000 }, 0)).toBeNull();
  });

  test("looking straight down has an up direction: y of the world", () => {
    const view = new View({ ...camera, yaw: -Math.PI / 2, pitch: Math.PI / 2 }, viewport);
    const north = view.project([1, -1, 0.5]);
    expect(north.x).toBeCloseTo(400, 6);
    expect(north.y).toBeLessThan(299);
  });
});

describe("camera moves", () => {
  test("orbit keeps the distance and stops at the poles", () => {
    const turned = orbit(camera, 1, 9);
    expect(turned.pitch).toBe(Math.PI / 2);
    expect(turned.distance).toBe(camera.distance);
  });

  test("pan moves the target under the pointer by the same pixels", () => {
    const view = new View(pan(camera, 40, -25, viewport), viewport);
    const { x, y } = view.project(camera.target);
    expect([x, y].map((value) => Math.round(value * 1e6) / 1e6)).toEqual([440, 275]);
  });

  test("zoom divides the distance", () => {
    expect(zoom(camera, 2).distance).toBe(6);
  });

  test("zoom to a pixel keeps what lies there at the depth of the target", () => {
    for (const from of [camera, above]) {
      const before = new View(from, viewport);
      const onTarget = pan(from, -150, 90, viewport).target;
      const pixel = before.project(onTarget);
      const after = new View(zoomTo(before, pixel, 1.7), viewport).project(onTarget);
      expect([after.x, after.y].map((value) => Number(value.toFixed(6)))).toEqual(
        [pixel.x, pixel.y].map((value) => Number(value.toFixed(6))),
      );
    }
  });

  test("limits keep the scene within reach, from wherever one got lost", () => {
    const frame = { centre: [0, 0, 0], radius: 5 } as unknown as Frame;
    const lost = limit({ ...camera, target: [1e7, 0, 0], distance: 1e9 }, frame);
    expect(Math.hypot(...lost.target)).toBeLessThanOrEqual(20 + 1e-9);
    expect(lost.distance).toBeLessThanOrEqual(150);
    expect(limit({ ...camera, distance: 0 }, frame).distance).toBeGreaterThan(0);
    expect(limit(camera, frame)).toEqual(camera);
  });

  test("a transition starts and ends where it should and turns the short way", () => {
    const to: Camera = { ...camera, yaw: camera.yaw + 2 * Math.PI - 0.2, distance: 3 };
    expect(between(camera, to, 0)).toEqual(camera);
    expect(between(camera, to, 1).distance).toBeCloseTo(3, 12);
    expect(between(camera, to, 0.5).yaw).toBeCloseTo(camera.yaw - 0.1, 12);
    expect(between(camera, to, 0.5).distance).toBeCloseTo(6, 12);
  });

  test.each(["space", "top", "side", "front", "plane"] as const)(
    "fit from %s shows all points and fills most of the view",
    (from) => {
      for (const size of [viewport, { width: 390, height: 700 }]) {
        const view = new View(fit(points, DIRECTIONS[from], size), size);
        const shares = points.flatMap((point) => {
          const { x, y } = view.project(point);
          return [Math.abs((2 * x) / size.width - 1), Math.abs((2 * y) / size.height - 1)];
        });
        expect(Math.max(...shares)).toBeLessThanOrEqual(0.85);
        expect(Math.max(...shares)).toBeGreaterThan(0.8);
      }
    },
  );

  test("fit keeps clear what lies over the view, also of points near the viewer", () => {
    const inset = { left: 300, top: 80, bottom: 40 };
    const near: Vec3[] = [...points, [5, -9, 0.2]];
    const view = new View(fit(near, DIRECTIONS.front, viewport, inset), viewport);
    for (const point of near) {
      const { x, y } = view.project(point);
      expect(x).toBeGreaterThan(inset.left);
      expect(x).toBeLessThan(viewport.width);
      expect(y).toBeGreaterThan(inset.top);
      expect(y).toBeLessThan(viewport.height - inset.bottom);
    }
  });
});
