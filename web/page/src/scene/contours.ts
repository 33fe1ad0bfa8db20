import { contours } from "d3-contour";
import { formatNumber } from "../controls/format";
import type { DrawList } from "./draw-list";
import { type FieldPicture, pointOfField, UNBOUNDED } from "./field";
import type { Vec3 } from "./geometry";
import type { Label, SceneInput } from "./input";
import { logLevels } from "./log-levels";

/** A line along which the field has one value. */
export interface ContourLine {
  /** In the unit that is shown: the numbers of the field times the factor. */
  readonly level: number;
  /** x, y, z of each corner, metres. */
  readonly points: Float32Array;
  /** Where its value may be written, best first; nowhere on lines too short for it. */
  readonly labels: readonly Vec3[];
}

const MOST_LEVELS = 12;
/** A line gets a label if it is this share of the grid's shorter edge long. */
const LEAST_LABELLED = 0.25;
/** Shares of its length at which the label may stand, best first. */
const LABELLED_AT = [0.5, 0.35, 0.65, 0.2, 0.8];

/** In cells: the middle of cell (i, j) is at (i + 0.5, j + 0.5). */
type Place = readonly [number, number];

const known = new WeakMap<FieldPicture, Map<number, readonly ContourLine[]>>();

/** The contour lines of a field at round values of `unitScale` times its numbers; found once for each field. */
export function contourLines(picture: FieldPicture, unitScale = 1): readonly ContourLine[] {
  const ofPicture = known.get(picture) ?? new Map<number, readonly ContourLine[]>();
  const lines = ofPicture.get(unitScale) ?? findLines(picture, unitScale);
  known.set(picture, ofPicture.set(unitScale, lines));
  return lines;
}

function findLines(picture: FieldPicture, unitScale: number): ContourLine[] {
  const { width, height, low, high } = picture;
  if (width < 2 || height < 2) return [];
  const logs = Array.from(picture.values, (value) => (value < UNBOUNDED ? Math.log10(value) : Infinity));
  const finder = contours().size([width, height]);
  return logLevels(low * unitScale, high * unitScale, MOST_LEVELS).flatMap((level) => {
    const { coordinates } = finder.contour(logs, Math.log10(level / unitScale));
    const rings = coordinates.flat() as unknown as Place[][];
    return rings.flatMap((ring) => openLines(ring, picture)).map((line) => placed(line, level, picture));
  });
}

/** The parts of a ring that are contours: not along the border of the grid, not beside cells without a bound. */
function openLines(ring: readonly Place[], picture: FieldPicture): Place[][] {
  const good = ring.map((place) => !onBorder(place, picture) && bounded(place, picture));
  if (!good.includes(false)) return [[...ring]];
  // The last corner of a ring is its first: begin at a gap, so that no line is cut there.
  const corners = ring.length - 1;
  const gap = good.indexOf(false);
  const lines: Place[][] = [[]];
  for (let i = 1; i <= corners; i++) {
    const at = (gap + i) % corners;
    if (good[at]) lines.at(-1)!.push(ring[at]);
    else lines.push([]);
  }
  return lines.filter((line) => line.length > 1);
}

function onBorder([x, y]: Place, { width, height }: FieldPicture): boolean {
  return x <= 0 || y <= 0 || x >= width || y >= height;
}

/** Whether all cells with middles within one cell of the place have a bound. */
function bounded([x, y]: Place, { values, width, height }: FieldPicture): boolean {
  const near = (place: number, size: number) => [
    Math.max(0, Math.ceil(place - 1.5)),
    Math.min(size - 1, Math.floor(place + 0.5)),
  ];
  const [[left, right], [top, bottom]] = [near(x, width), near(y, height)];
  for (let j = top; j <= bottom; j++)
    for (let i = left; i <= right; i++) if (values[j * width + i] >= UNBOUNDED) return false;
  return true;
}

function placed(line: readonly Place[], level: number, picture: FieldPicture): ContourLine {
  const { width, height } = picture;
  const points = line.map(([x, y]) => pointOfField(picture, x / width, y / height));
  const along = [0];
  for (let i = 1; i < line.length; i++)
    along.push(along[i - 1] + Math.hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]));
  const length = along.at(-1)!;
  const labelled = length >= LEAST_LABELLED * Math.min(width, height);
  const at = (share: number) => points[along.findIndex((distance) => distance >= share * length)];
  const labels = labelled ? LABELLED_AT.map(at) : [];
  return { level, points: Float32Array.from(points.flat()), labels };
}

/** Draws the contour lines of a field; a layer calls it with the factor to the unit that is shown. */
export function fieldContours(
  { palette }: SceneInput,
  out: DrawList,
  picture: FieldPicture,
  unitScale = 1,
): void {
  const style = { width: 1, color: palette.rgba("ink", 0.75) };
  for (const { points } of contourLines(picture, unitScale))
    out.path(points, 0, points.length / 3 - 1, style);
}

/** The values of the lines, on them. */
export function fieldContourLabels(picture: FieldPicture, unitScale: number, unit: string): Label[] {
  return contourLines(picture, unitScale).flatMap(({ level, labels: [at, ...elsewhere] }, i) =>
    at
      ? [
          {
            id: `contour ${i}`,
            at,
            elsewhere,
            text: `${formatNumber(level)} ${unit}`,
            kind: "tick" as const,
            offset: { x: 0, y: 0 },
          },
        ]
      : [],
  );
}
