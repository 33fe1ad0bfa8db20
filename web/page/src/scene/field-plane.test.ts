import { expect, test } from "vitest";
import type { Camera } from "./camera";
import { type FieldPicture, pointOfField } from "./field";
import { fieldFromPixel } from "./field-plane";
import { dot, type Vec3 } from "./geometry";
import { View } from "./view";

const viewport = { width: 1440, height: 900 };
const camera: Camera = { target: [1, 2, 0.5], yaw: 0.7, pitch: 0.6, distance: 12, orthographic: false };
const rectangle: Pick<FieldPicture, "corner" | "u" | "v"> = {
  corner: [-3, -1, 0.2],
  u: [6, 1, 0],
  v: [-0.5, 4, 1],
};
const picture = rectangle as FieldPicture;

function placeAt(view: View, x: number, y: number): { s: number; t: number; w: number } {
  const [s, t, w] = fieldFromPixel(view, picture)!.map((row) => dot(row, [x, y, 1]));
  return { s: s / w, t: t / w, w };
}

const cameras: [string, Camera][] = [
  ["in perspective", camera],
  ["from above with parallel rays", { ...camera, pitch: Math.PI / 2, orthographic: true }],
  ["from below", { ...camera, pitch: -0.9, yaw: 3 }],
];

test.each(cameras)("finds the place that is seen at a pixel %s", (_name, looking) => {
  const view = new View(looking, viewport);
  for (const [s, t] of [
    [0, 0],
    [1, 0],
    [0.25, 0.75],
    [1, 1],
  ]) {
    const { x, y, depth } = view.project(pointOfField(picture, s, t));
    const found = placeAt(view, x, y);
    // Less than a twentieth of a pixel of the 1440: the matrix is of single precision.
    expect(Math.hypot(found.s - s, found.t - t)).toBeLessThan(3e-5);
    expect(Math.sign(found.w)).toBe(Math.sign(depth));
  }
});

test("another pixel is another place", () => {
  const view = new View(camera, viewport);
  const { x, y } = view.project(pointOfField(picture, 0.5, 0.5));
  const found = placeAt(view, x + 2, y);
  expect(Math.hypot(found.s - 0.5, found.t - 0.5)).toBeGreaterThan(1e-3);
});

test("what lies behind the viewer is told from what lies before", () => {
  const inside = new View({ ...camera, target: [0, 1, 0.5], distance: 1, pitch: 0.3 }, viewport);
  const behind = [0, 0.5, 1].flatMap((s) => [0, 0.5, 1].map((t) => pointOfField(picture, s, t)));
  const signs = behind.map((point) => {
    const { x, y, depth } = inside.project(point);
    return [Math.sign(depth), Math.sign(placeAt(inside, x, y).w)];
  });
  expect(signs.map(([depth]) => depth)).toContain(-1);
  for (const [depth, w] of signs) expect(w).toBe(depth);
});

test("a rectangle seen edge-on is nowhere", () => {
  const level = { ...picture, corner: [0, 0, 0.5] as Vec3, u: [1, 0, 0] as Vec3, v: [0, 1, 0] as Vec3 };
  expect(fieldFromPixel(new View({ ...camera, pitch: 0 }, viewport), level)).toBeNull();
});
