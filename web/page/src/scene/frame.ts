import type { LabRun } from "../lab";
import { pointAt } from "../run";
import type { Scenario } from "../scenario";
import { add, length, lift, niceBelow, scale, sub, type Vec3 } from "./geometry";

/** What the camera is asked to show: all anchors, or the body along its track. */
export type Subject = "anchors" | "body";

/** The part of space that is shown. It changes when the view is fitted, never while something is dragged. */
export interface Frame {
  readonly centre: Vec3;
  /** Metres from the centre to the farthest point. */
  readonly radius: number;
  /** What must be in view: anchors or track, with some room around. */
  readonly points: readonly Vec3[];
  /** Metres the ground grid reaches to either side of the centre, along x and y. */
  readonly reach: readonly [number, number];
  /** Height of the ground grid. */
  readonly ground: number;
  /** Metres between grid lines. */
  readonly spacing: number;
  /** How many times larger the body and the errors around it are drawn than they are. */
  readonly magnification: number;
}

/** Below this share of the view a body is too small to see and is drawn larger. */
const VISIBLE_SHARE = 0.05;
const DRAWN_SHARE = 0.18;

export function frameOf(scenario: Scenario, run: LabRun | null, subject: Subject): Frame {
  const anchors = run ? run.anchors : scenario.anchors;
  const track = run ? trackPoints(run) : [lift(scenario.start.position)];
  const bodyRadius = Math.max(1e-6, ...scenario.sensors.map((sensor) => length(lift(sensor))));
  const subjects = subject === "anchors" ? [...anchors.map(lift), ...track] : track;
  const margin = subject === "anchors" ? bodyRadius : 3 * bodyRadius;
  const [low, high] = box(subjects, margin);
  const centre = scale(add(low, high), 0.5);
  const radius = length(sub(high, centre));
  const ground = groundBelow(low[2] + margin, radius);
  const share = bodyRadius / radius;
  return {
    centre,
    radius,
    points: corners(low, high, subject === "anchors" ? ground : low[2]),
    reach: [high[0] - centre[0], high[1] - centre[1]],
    ground,
    spacing: niceBelow(radius / 2),
    magnification: share < VISIBLE_SHARE ? roundMagnification(DRAWN_SHARE / share) : 1,
  };
}

/** Corners of the box, which stands on the ground. */
function corners(low: Vec3, high: Vec3, ground: number): Vec3[] {
  const [bottom, top] = [Math.min(low[2], ground), high[2]];
  return [bottom, top].flatMap((z) =>
    [low[0], high[0]].flatMap((x) => [low[1], high[1]].map((y): Vec3 => [x, y, z])),
  );
}

function trackPoints(run: LabRun): Vec3[] {
  return Array.from({ length: run.steps }, (_, step) => pointAt(run.truth.positions, step, run.dimension));
}

function box(points: Vec3[], margin: number): [Vec3, Vec3] {
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
