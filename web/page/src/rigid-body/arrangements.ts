/** Anchors arranged anew within the box that they stand in: pure functions of the box and of how many there are. */

export interface Box {
  readonly least: readonly number[];
  readonly most: readonly number[];
}

export type Arrangement = "corners" | "ceiling" | "ring" | "line";

export function boxOf(points: readonly (readonly number[])[]): Box {
  const axes = points[0].map((_, axis) => points.map((point) => point[axis]));
  return {
    least: axes.map((values) => Math.min(...values)),
    most: axes.map((values) => Math.max(...values)),
  };
}

/** The arrangements that a dimension has: the plane has no ceiling. */
export function arrangementsIn(dimension: number): Arrangement[] {
  return dimension === 2 ? ["corners", "ring", "line"] : ["corners", "ceiling", "ring", "line"];
}

export function arrange(arrangement: Arrangement, box: Box, count: number): number[][] {
  const points = {
    corners: () => corners(box),
    ceiling: () => onCircle(box, count, 1),
    ring: () => onCircle(box, count, 0.5),
    line: () => onLine(box, count),
  }[arrangement]();
  return points.map((point) => point.map((value) => Number(value.toPrecision(4)) + 0));
}

/** All corners of the box: 8 in space, 4 in the plane. */
function corners({ least, most }: Box): number[][] {
  return Array.from({ length: 2 ** least.length }, (_, index) =>
    least.map((value, axis) => ((index >> axis) & 1 ? most[axis] : value)),
  );
}

/** Evenly on the ellipse that fills the box, at a share of its height. */
function onCircle({ least, most }: Box, count: number, height: number): number[][] {
  const at = (axis: number, share: number) => least[axis] + share * (most[axis] - least[axis]);
  return Array.from({ length: count }, (_, index) => {
    const angle = (2 * Math.PI * index) / count;
    const level = [at(0, 0.5 + 0.5 * Math.cos(angle)), at(1, 0.5 + 0.5 * Math.sin(angle))];
    return least.length === 2 ? level : [...level, at(2, height)];
  });
}

/** Evenly along x, in the middle of the other axes. */
function onLine({ least, most }: Box, count: number): number[][] {
  return Array.from({ length: count }, (_, index) =>
    least.map((value, axis) => {
      const share = axis > 0 || count === 1 ? 0.5 : index / (count - 1);
      return value + share * (most[axis] - value);
    }),
  );
}
