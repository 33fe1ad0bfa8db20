import type { Room } from "../family";

/** Edits as pure functions: the old value stays as it was. */

/** What is switched on, with or without some names, in the order in which they are listed. */
export function switched<T extends string>(
  on: readonly T[],
  names: readonly T[],
  wanted: boolean,
  order: readonly T[],
): T[] {
  return order.filter((name) => (names.includes(name) ? wanted : on.includes(name)));
}

/** Smallest step of ten that is below a thousandth of the scene: dragged coordinates are rounded to it. */
export function coordinateStep({ anchors }: Pick<Room, "anchors">): number {
  const extent = Math.max(1e-3, ...anchors.flat().map(Math.abs));
  return 10 ** Math.floor(Math.log10(extent / 200));
}

export function roundTo(value: number, step: number): number {
  const digits = Math.max(0, -Math.floor(Math.log10(step)));
  // Adding 0 turns -0, which JSON does not know, into 0.
  return Number((Math.round(value / step) * step).toFixed(digits)) + 0;
}

/** Where a new anchor helps to be seen: above the middle of the others, off their plane. */
export function newAnchorPosition(room: Pick<Room, "anchors" | "dimension">): number[] {
  const step = coordinateStep(room);
  const count = Math.max(1, room.anchors.length);
  const extent = Math.max(1, ...room.anchors.flat().map(Math.abs));
  return Array.from({ length: room.dimension }, (_, axis) => {
    const mean = room.anchors.reduce((sum, anchor) => sum + anchor[axis], 0) / count;
    const offset = axis === room.dimension - 1 ? 0.5 * extent : 0.1 * extent * ((count % 3) - 1);
    return roundTo(mean + offset, step);
  });
}
