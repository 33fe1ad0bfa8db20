import { expect, test } from "vitest";
import type { Camera } from "./camera";
import type { Label } from "./input";
import { type Box, LabelPlacer } from "./labels";
import { View } from "./view";

const camera: Camera = { target: [0, 0, 0], yaw: -1, pitch: 0.5, distance: 20, orthographic: false };
const view = new View(camera, { width: 800, height: 600 });
const label = (kind: Label["kind"], more: Partial<Label> = {}): Label => ({
  id: kind,
  at: [0, 0, 0],
  text: "keep out 1",
  kind,
  ...more,
});
/** Covers the middle of the view, where the labels' point is. */
const around = (half: number): Box => ({ x: 400, y: 300, halfWidth: half, halfHeight: half });
const placed = (labels: Label[], covered: Box[] = []) => new LabelPlacer().place(labels, view, 15, covered);

test("a name that finds no place beside its point stands a little farther", () => {
  const [near] = placed([label("name")]);
  const [far] = placed([label("name")], [around(15)]);
  const away = ({ x, y }: { x: number; y: number }) => Math.hypot(x - 400, y - 300);
  expect(away(far)).toBeGreaterThan(away(near));
  expect(placed([label("axis")], [around(15)])).toEqual([]);
});

test("without any place names are left out, but not numbers of anchors and what is chosen", () => {
  const covered = [around(300)];
  expect(placed([label("name"), label("handle")], covered)).toEqual([]);
  expect(placed([label("anchor"), label("handle", { strong: true })], covered)).toHaveLength(2);
});

test("two names of one point do not lie on each other", () => {
  const [a, b] = placed([label("name"), label("name", { id: "other" })]);
  expect(Math.abs(a.y - b.y) >= 12 || Math.abs(a.x - b.x) >= 80).toBe(true);
});
