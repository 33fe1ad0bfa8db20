/** Bodies by name: where their sensors sit, centred on the body's origin, one metre from end to end. */

export interface Topology {
  readonly name: string;
  readonly sensors: readonly (readonly number[])[];
}

const SIGNS = [-1, 1];
const SQUARE = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
];

const SHAPES: Record<number, Record<string, number[][]>> = {
  2: {
    Triangle: onCircle(3),
    Square: SQUARE,
    Cross: [
      [1, 0],
      [0, 1],
      [-1, 0],
      [0, -1],
    ],
    Rod: SIGNS.map((x) => [x, 0]),
  },
  3: {
    Pyramid: [...SQUARE.map(([x, y]) => [x, y, -0.4]), [0, 0, 1.6]],
    Tetrahedron: [
      [1, 1, 1],
      [1, -1, -1],
      [-1, 1, -1],
      [-1, -1, 1],
    ],
    Cube: SIGNS.flatMap((x) => SIGNS.flatMap((y) => SIGNS.map((z) => [x, y, z]))),
    Cross: [0, 1, 2].flatMap((axis) => SIGNS.map((sign) => [0, 0, 0].with(axis, sign))),
    "Flat triangle": onCircle(3).map((point) => [...point, 0]),
    "Flat square": SQUARE.map((point) => [...point, 0]),
    Rod: SIGNS.map((x) => [x, 0, 0]),
  },
};

export function topologiesIn(dimension: number): Topology[] {
  return Object.entries(SHAPES[dimension]).map(([name, points]) => ({ name, sensors: scaled(points, 1) }));
}

/** Largest distance between two sensors, m. */
export function sizeOf(sensors: readonly (readonly number[])[]): number {
  return Math.max(...sensors.flatMap((one) => sensors.map((other) => distance(one, other))));
}

/** The same body in another size. */
export function scaled(sensors: readonly (readonly number[])[], size: number): number[][] {
  const factor = size / sizeOf(sensors);
  return sensors.map((sensor) => sensor.map((value) => Number((value * factor).toPrecision(9)) + 0));
}

/** The body that these sensors make in whatever size; null where it is none of those with a name. */
export function topologyOf(sensors: readonly (readonly number[])[]): string | null {
  const size = sizeOf(sensors);
  const fits = ({ sensors: shape }: Topology) =>
    shape.length === sensors.length &&
    shape.every(
      (point, index) =>
        distance(
          point.map((value) => value * size),
          sensors[index],
        ) <
        1e-4 * size,
    );
  return topologiesIn(sensors[0].length).find(fits)?.name ?? null;
}

function distance(one: readonly number[], other: readonly number[]): number {
  return Math.hypot(...one.map((value, axis) => value - other[axis]));
}

function onCircle(count: number): number[][] {
  return Array.from({ length: count }, (_, index) => {
    const angle = (2 * Math.PI * index) / count;
    return [Math.cos(angle), Math.sin(angle)];
  });
}
