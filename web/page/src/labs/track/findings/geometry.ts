import { formatNumber, formatReading } from "../../../controls/format";
import type { Run } from "../../../run";
import { weakDirection } from "../directions";
import { asSentence, countOf, startOf } from "../../../words";
import type { Finding } from "../../../findings";

/** What the anchors cannot show, or show badly. */
export function weakGeometry(run: Run, step: number): Finding | null {
  const [bound] = run.bounds.filter((entry) => entry.name === "posterior_crb");
  const weak = bound ? weakDirection(bound.positionCovariances, step, run.dimension) : null;
  const { unseen } = run.geometry;
  if (unseen !== null) return { weight: 65, text: asSentence(unseen) };
  if (weak === null) return null;
  const ratio = formatNumber(Number((weak.along / weak.across).toPrecision(2)));
  const effect = (across: string) => `${weak.name} is known ${ratio} times worse than position ${across}`;
  const weight = 40 + Math.min(20, weak.along / weak.across);
  const cause = thinCause(run, weak.direction);
  if (cause === null) return { weight, text: `${startOf(effect("across it"))}.` };
  return { weight, text: `${cause}: ${effect(run.dimension === 3 ? "in it" : "along it")}.` };
}

/** Anchors thinner than this part of their extent are called flat. */
const FLAT = 0.15;
/** How much of the weak direction must be the plane's normal for the plane to be its cause. */
const NORMAL = 0.8;

/** "Four anchors lie within 0.3 m of one plane", where that is why the direction is weak. */
function thinCause({ geometry, anchors, dimension }: Run, direction: readonly number[]): string | null {
  const { plane, line } = geometry.anchors;
  const lie = `${startOf(countOf(anchors.length))} anchors lie`;
  const extent = Math.max(...anchors.map((one) => distance(one, anchors[0])));
  if (dimension === 3 && plane && plane.thickness < FLAT * extent) {
    const aligned = Math.abs(dot(plane.direction, direction)) > NORMAL;
    return aligned ? `${lie} within ${formatReading(plane.thickness)} m of one plane` : null;
  }
  const across = Math.abs(dot(line.direction, direction)) < Math.sqrt(1 - NORMAL ** 2);
  if (dimension === 2 && line.thickness < FLAT * extent && across)
    return `${lie} within ${formatReading(line.thickness)} m of one line`;
  return null;
}

function dot(one: readonly number[], other: readonly number[]): number {
  return one.reduce((sum, value, index) => sum + value * other[index], 0);
}

function distance(one: readonly number[], other: readonly number[]): number {
  return Math.hypot(...one.map((value, index) => value - other[index]));
}
