import { pointAt, type Run } from "../run";
import type { Scenario } from "../scenario";
import { add, length, lift, niceBelow, scale, sub, type Vec3 } from "./geometry";

/** What the camera is asked to show: all anchors, or the body along its track. */
export type Subject = "anchors" | "body";

/** The part of space that is shown. It changes when the view is fitted, never while something is dragged. */
export interface Frame {
  readonly centre: Vec3;
  readonly radius: number;
  /** Height of the ground grid. */
  readonly ground: number;
  /** Metres between grid lines. */
  readonly spacing: number;
  /** How many times larger the body and the errors around it are drawn than they are. */
  readonly magnification: number;
}

/** Below this share of the view a body is too small to see and is drawn larger. */
const VISIBLE_SHARE = 0.05;
const DRAWN_SHARE = 0.09;

export function frameOf(scenario: Scenario, run: Run | null, subject: Subject): Frame {
  const anchors = run ? run.anchors : scenario.anchors;
  const track = run ? trackPoints(run) : [lift(scenario.start.position)];
  const bodyRadius = Math.max(1e-6, ...scenario.sensors.map((sensor) => length(lift(sensor))));
  const points = subject === "anchors" ? [...anchors.map(lift), ...track] : track;
  const [low, high] = box(points);
  const centre = scale(add(low, high), 0.5);
  const reach = Math.max(...points.map((point) => length(sub(point, centre))));
  const radius = subject === "anchors" ? Math.max(reach, 2 * bodyRadius) * 1.08 : reach + 3 * bodyRadius;
  const share = bodyRadius / radius;
  return {
    centre,
    radius,
    ground: groundBelow(low[2], radius),
    spacing: niceBelow(radius / 2),
    magnification: share < VISIBLE_SHARE ? niceBelow((DRAWN_SHARE * radius) / bodyRadius) : 1,
  };
}

function trackPoints(run: Run): Vec3[] {
  return Array.from({ length: run.steps }, (_, step) => pointAt(run.truth.positions, step, run.dimension));
}

function box(points: Vec3[]): [Vec3, Vec3] {
  const bound = (pick: (...values: number[]) => number, axis: 0 | 1 | 2) =>
    points.reduce((value, point) => pick(value, point[axis]), points[0][axis]);
  return [
    [bound(Math.min, 0), bound(Math.min, 1), bound(Math.min, 2)],
    [bound(Math.max, 0), bound(Math.max, 1), bound(Math.max, 2)],
  ];
}

/** The floor is at 0 where nothing lies below it, else a round height below everything. */
function groundBelow(lowest: number, radius: number): number {
  if (lowest >= 0 && lowest < radius) return 0;
  const step = niceBelow(radius / 4);
  return Math.floor(lowest / step) * step;
}
