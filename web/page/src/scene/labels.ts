import type { Label } from "./input";
import type { Pixel, View } from "./view";

export interface PlacedLabel extends Label {
  /** Middle of the text, CSS pixels. */
  readonly x: number;
  readonly y: number;
  /** The point that it names. */
  readonly point: Pixel;
}

/** A rectangle around its middle, CSS pixels. */
export interface Box extends Pixel {
  readonly halfWidth: number;
  readonly halfHeight: number;
}

/** Numbers of anchors come first, then the other names, and the scale takes what is left. */
const RANK = { anchor: 0, handle: 1, axis: 2, name: 3, tick: 4 } as const;
/** Sizes of the kinds in Scene's style, as shares of the page's. */
const SIZE = { anchor: 1.05, handle: 0.85, axis: 0.95, name: 0.8, tick: 0.8 } as const;
const CHARACTER_WIDTH = 0.58;
/** CSS pixels from a point to the nearest edge of its text, and what no text may cover around a point. */
const GAP = 7;
/** The same where there is no place so near. */
const FARTHER = 22;
/** Directions from the point to the middle of the text, best first. */
const SIDES: readonly (readonly [number, number])[] = [
  [1, -1],
  [-1, -1],
  [1, 0.2],
  [-1, 0.2],
  [0, -1.3],
  [1, 1],
  [-1, 1],
  [0, 1.3],
];

/**
 * Finds a place for each label beside its point where it lies on no other label and on no named point. One that has
 * a place keeps it from picture to picture as long as it is free; one without a free place is left out, but anchors
 * always have their number, and what is chosen its name.
 */
export class LabelPlacer {
  #sides = new Map<string, number>();

  /** `covered` lies over the scene, so that no label would be seen there. */
  place(labels: readonly Label[], view: View, fontSize: number, covered: readonly Box[]): PlacedLabel[] {
    const { width, height } = view.viewport;
    const visible = labels
      .map((label) => ({ label, point: view.project(label.at) }))
      .filter(({ point: { x, y, depth } }) => depth > 0 && x >= 0 && y >= 0 && x <= width && y <= height)
      .sort((a, b) => RANK[a.label.kind] - RANK[b.label.kind]);
    const named = visible.filter(({ label }) => label.kind === "anchor" || label.kind === "handle");
    const taken = [
      ...covered,
      ...named.map(({ point }) => ({ x: point.x, y: point.y, halfWidth: GAP, halfHeight: GAP })),
    ];
    const sides = new Map<string, number>();
    const placed: PlacedLabel[] = [];
    for (const { label, point } of visible) {
      const others = (label.elsewhere ?? []).map((at) => view.project(at));
      const boxes = [point, ...others].flatMap((at) => candidates(label, at, fontSize));
      const order = [this.#sides.get(label.id) ?? 0, ...boxes.keys()];
      const free = order.find(
        (side) => inside(boxes[side], view) && !taken.some((box) => overlap(box, boxes[side])),
      );
      const side = free ?? (label.kind === "anchor" || label.strong ? 0 : undefined);
      if (side === undefined) continue;
      const { x, y } = boxes[side];
      sides.set(label.id, side);
      taken.push(boxes[side]);
      placed.push({ ...label, x: Math.round(x), y: Math.round(y), point });
    }
    this.#sides = sides;
    return placed;
  }
}

function candidates(label: Label, point: Pixel, fontSize: number): Box[] {
  const size = SIZE[label.kind] * fontSize;
  const halfWidth = (label.text.length * CHARACTER_WIDTH * size) / 2 + 1;
  const halfHeight = size / 2;
  const box = (dx: number, dy: number) => ({ x: point.x + dx, y: point.y + dy, halfWidth, halfHeight });
  const own = label.offset ? [box(label.offset.x, label.offset.y)] : [];
  if (label.kind === "tick") return own;
  const ring = (gap: number) => SIDES.map(([x, y]) => box(x * (halfWidth + gap), y * (halfHeight + gap)));
  return [...own, ...ring(GAP), ...(label.kind === "axis" ? [] : ring(FARTHER))];
}

function inside({ x, y, halfWidth, halfHeight }: Box, { viewport }: View): boolean {
  const within = (value: number, half: number, size: number) => value >= half && value <= size - half;
  return within(x, halfWidth, viewport.width) && within(y, halfHeight, viewport.height);
}

function overlap(a: Box, b: Box): boolean {
  return Math.abs(a.x - b.x) < a.halfWidth + b.halfWidth && Math.abs(a.y - b.y) < a.halfHeight + b.halfHeight;
}
