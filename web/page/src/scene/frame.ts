import type { Room } from "../family";
import type { LabRun } from "../lab";
import { pointAt } from "../run";
import { add, length, lift, niceBelow, scale, sub, type Vec3 } from "./geometry";

/** What the camera is asked to show: everything, or the body from near. */
export type Subject = "all" | "body";

/** The part of space that is shown. It changes when the view is fitted, never while something is dragged. */
export interface Frame {
  /** Scenes in the plane have no height. */
  readonly flat: boolean;
  /** What is fitted into the view. */
  readonly points: readonly Vec3[];
  /** Opposite corners of the box around everything, its middle, and metres from there to a corner. */
  readonly whole: readonly [Vec3, Vec3];
  readonly centre: Vec3;
  readonly radius: number;
  /** Height of the floor. */
  readonly ground: number;
  /** How many times larger the body and the errors around it are drawn than they are. */
  readonly magnification: number;
}

/** Below this share of the view a body is too small to see and is drawn larger. */
const VISIBLE_SHARE = 0.05;
const DRAWN_SHARE = 0.18;

/** How many times its own radius is seen around a body. */
const AROUND_BODY = 1.1;

export function frameOf(room: Room, run: LabRun | null, subject: Subject, step: number): Frame {
  const anchors = (run ? run.anchors : room.anchors).map(lift);
  const track = [lift(room.start), ...(run ? trackPoints(run) : [])];
  const bodyRadius = Math.max(1e-6, ...room.body.map((point) => length(lift(point))));
  const extent = room.extent?.map(lift);
  const around = extent ? 0 : bodyRadius;
  const whole = box([...anchors, ...track, ...(extent ?? [])], around);
  const near = box([bodyPosition(room, run, step)], AROUND_BODY * bodyRadius);
  const radius = halfDiagonal(whole);
  const ground = groundBelow(whole[0][2] + around, radius);
  const feet = anchors.map(([x, y]): Vec3 => [x, y, ground]);
  const share = bodyRadius / halfDiagonal(subject === "all" ? whole : near);
  return {
    flat: room.dimension === 2,
    points:
      subject === "all"
        ? [...anchors, ...feet, ...corners(box(track, around)), ...(extent ?? [])]
        : (extent ?? corners(near)),
    whole,
    centre: scale(add(...whole), 0.5),
    radius,
    ground,
    magnification: share < VISIBLE_SHARE ? roundMagnification(DRAWN_SHARE / share) : 1,
  };
}

/** The true position of the body at a step, or where it starts while there is no run. */
export function bodyPosition(room: Room, run: LabRun | null, step: number): Vec3 {
  return run ? pointAt(run.truth.positions, step, run.dimension) : lift(room.start);
}

type Box = readonly [Vec3, Vec3];

const halfDiagonal = ([low, high]: Box): number => length(sub(high, low)) / 2;

function corners([low, high]: Box): Vec3[] {
  return [low[2], high[2]].flatMap((z) =>
    [low[0], high[0]].flatMap((x) => [low[1], high[1]].map((y): Vec3 => [x, y, z])),
  );
}

function trackPoints(run: LabRun): Vec3[] {
  return Array.from({ length: run.steps }, (_, step) => pointAt(run.truth.positions, step, run.dimension));
}

function box(points: readonly Vec3[], margin: number): Box {
  const low = (axis: 0 | 1 | 2) => Math.min(...points.map((point) => point[axis])) - margin;
  const high = (axis: 0 | 1 | 2) => Math.max(...points.map((point) => point[axis])) + margin;
  return [
    [low(0), low(1), low(2)],
    [high(0), high(1), high(2)],
  ];
}

/** The floor is at 0 where nothing lies below it, else a round height below everything. */
function groundBelow(lowest: number, radius: number): number {
  if (lowest >= 0 && lowest < radius) return 0;
  const step = niceBelow(radius / 4);
  return Math.floor(lowest / step) * step;
}

function roundMagnification(value: number): number {
  return value < 10 ? Math.floor(value) : niceBelow(value);
}
