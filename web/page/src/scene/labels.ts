import type { Label } from "./input";
import type { View } from "./camera";

export interface PlacedLabel {
  readonly x: number;
  readonly y: number;
  readonly text: string;
  readonly kind: Label["kind"];
  readonly strong: boolean;
}

const OFFSETS = { anchor: [11, -10], tick: [0, 4], axis: [6, -4] } as const;
const CHARACTER_WIDTH = 0.6;

/** Pixel positions for the labels, first come first served: one that would lie on another is left out. */
export function placeLabels(labels: readonly Label[], view: View, fontSize: number): PlacedLabel[] {
  const placed: PlacedLabel[] = [];
  for (const { at, text, kind, strong } of labels) {
    const { x, y, depth } = view.project(at);
    if (depth <= 0 || x < 0 || y < 0 || x > view.viewport.width || y > view.viewport.height) continue;
    const [dx, dy] = OFFSETS[kind];
    const candidate = { x: x + dx, y: y + dy, text, kind, strong: strong ?? false };
    if (kind !== "tick" || placed.every((other) => !overlap(candidate, other, fontSize)))
      placed.push(candidate);
  }
  return placed;
}

function overlap(a: PlacedLabel, b: PlacedLabel, fontSize: number): boolean {
  const reach = ((a.text.length + b.text.length) / 2) * CHARACTER_WIDTH * fontSize + 4;
  return Math.abs(a.x - b.x) < reach && Math.abs(a.y - b.y) < fontSize;
}
