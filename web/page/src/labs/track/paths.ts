import type { Run } from "../../run";
import { pointAt } from "../../run";
import type { PathSettings, Scenario } from "../../scenario";
import { boxOf } from "../../rigid-body/arrangements";
import { simplified } from "./drawing";

/** What the body can follow, and what each path starts as. */

export type PathKind = PathSettings["kind"] | "none";

const LABELS: Record<PathKind, string> = {
  none: "constant velocity",
  turn: "turn",
  figure_eight: "figure eight",
  helix: "helix",
  drawn: "drawn by hand",
};

/** The paths of a dimension: the plane has no height for a helix to climb. */
export function pathOptions(dimension: number): { value: PathKind; label: string }[] {
  const kinds = Object.keys(LABELS) as PathKind[];
  return kinds
    .filter((kind) => dimension === 3 || kind !== "helix")
    .map((value) => ({ value, label: LABELS[value] }));
}

/** A first drawn path has this many points at most: few enough to be moved one by one. */
const FIRST_POINTS = 8;
/** And does not follow the disturbances, which are drawn anew. */
const FIRST_TOLERANCE = 0.05;

/** The scenario with another path, of a size that fits the room: once round in the time of the run, without drift. */
export function withPath(
  scenario: Scenario,
  kind: PathKind,
  run: Run | null,
  reference: Scenario | null,
): Scenario {
  const { motion } = scenario;
  if (kind === "none") {
    // A preset's own velocities come back; a preset with a path has none that would lead anywhere.
    const back = reference?.motion.path === null ? reference.motion : motion;
    const { velocity, angular_velocity } = back;
    return { ...scenario, motion: { ...motion, path: null, velocity, angular_velocity } };
  }
  const still = {
    velocity: motion.velocity.map(() => 0),
    angular_velocity: motion.angular_velocity.map(() => 0),
  };
  return { ...scenario, motion: { ...motion, ...still, path: firstPath(scenario, kind, run) } };
}

function firstPath(scenario: Scenario, kind: PathSettings["kind"], run: Run | null): PathSettings {
  const { least, most } = boxOf(scenario.anchors);
  const extents = most.map((value, axis) => value - least[axis] || 1);
  const radius = rounded(0.15 * Math.min(...extents.slice(0, 2)));
  const period = rounded(scenario.interval * scenario.steps);
  const before = scenario.motion.path;
  const side = before && "side" in before ? before.side : "left";
  if (kind === "drawn") return { kind, points: trackPoints(scenario, run), closed: false, period };
  if (kind === "figure_eight") return { kind, radius, period };
  if (kind === "turn") return { kind, radius, period, side };
  return { kind, radius, period: rounded(period / 2), climb: rounded(0.2 * extents[2]), side };
}

/** The track as it was, so that a drawn path begins with something to change. */
function trackPoints({ start, dimension }: Scenario, run: Run | null): number[][] {
  const steps = run?.dimension === dimension ? run.steps : 0;
  const track = Array.from({ length: steps }, (_, step) =>
    pointAt(run!.truth.positions, step, dimension).slice(0, dimension),
  );
  const [, ...points] = simplified([start.position, ...track], FIRST_POINTS + 1, FIRST_TOLERANCE);
  return points.length > 0
    ? points.map((point) => point.map(rounded))
    : [start.position.map((value) => value + 1)];
}

/** Speed along the path, m/s: of a drawn one along the straight lines between its points. */
export function speedOf({ motion, start }: Scenario): number | null {
  const { path } = motion;
  if (path === null) return null;
  if (path.kind === "drawn") return lengthOf(path, start.position) / path.period;
  const circles = path.kind === "figure_eight" ? 2 : 1;
  const level = circles * 2 * Math.PI * path.radius;
  return Math.hypot(level, path.kind === "helix" ? path.climb : 0) / path.period;
}

function lengthOf(
  { points, closed }: Extract<PathSettings, { kind: "drawn" }>,
  start: readonly number[],
): number {
  const through = [start, ...points, ...(closed ? [start] : [])];
  const pieces = through
    .slice(1)
    .map((point, index) => point.map((value, axis) => value - through[index][axis]));
  return pieces.reduce((sum, piece) => sum + Math.hypot(...piece), 0);
}

function rounded(value: number): number {
  return Number(value.toPrecision(3)) + 0;
}
