import { DEGREES_PER_RADIAN, formatPoint, formatReading } from "../../controls/format";
import type { Advice } from "../../generated/Advice";
import type { Region } from "../../generated/Region";
import { boxOf } from "../../rigid-body/arrangements";
import type { Scenario } from "../../scenario";
import { newObstacle } from "./availability";

/** Edits of what the placement adviser looks for, and its numbers in words. */

type Placement = Scenario["placement"];

export function withPlacement(scenario: Scenario, change: Partial<Placement>): Scenario {
  return { ...scenario, placement: { ...scenario.placement, ...change } };
}

/** The scenario with one anchor that stays where it is, or may move. */
export function withFixed(scenario: Scenario, anchor: number, stays: boolean): Scenario {
  const others = scenario.placement.fixed.filter((index) => index !== anchor);
  const fixed = stays ? [...others, anchor].sort((a, b) => a - b) : others;
  return withPlacement(scenario, { fixed });
}

/** Part of the room that the body first roams in. */
const ROAMED = 0.5;

/** A box around the body, half as large as that of the anchors. */
export function firstRegion({ anchors, start }: Scenario): Region {
  const { least, most } = boxOf(anchors);
  const reach = most.map((value, axis) => (ROAMED / 2) * (value - least[axis]));
  return {
    low: start.position.map((value, axis) => rounded(value - reach[axis])),
    high: start.position.map((value, axis) => rounded(value + reach[axis])),
  };
}

/** The box of the anchors, which is what limits them where nothing is said. */
export function firstLimits({ anchors }: Scenario): Region {
  const { least, most } = boxOf(anchors);
  return { low: [...least], high: [...most] };
}

export function newKeepOut(scenario: Scenario): Region {
  const box = newObstacle(scenario, "box");
  return box.kind === "box" ? { low: box.low, high: box.high } : firstLimits(scenario);
}

/** "5.5 mm", "0.21 deg": in the unit in which it is read best. */
export function formatValue(value: number | null, unit: string): string {
  if (value === null) return "no bound";
  if (unit === "rad") return `${formatReading(value * DEGREES_PER_RADIAN)} deg`;
  return value < 0.1 ? `${formatReading(1000 * value)} mm` : `${formatReading(value)} m`;
}

/** How good the value is beside the best found, in per cent; null where one of them does not exist. */
export function shareOfBest(value: number | null, best: number | null | undefined): number | null {
  if (value === null || best === null || best === undefined || !(value > 0)) return null;
  return (100 * best) / value;
}

/** Slopes below this part of the steepest are drawn as none. */
const FLAT = 1e-3;

/** For each anchor where it should go, the steepest of length 1; null for one that stays or has nothing to gain. */
export function downhillOf({ gradient }: Advice, fixed: readonly number[]): (number[] | null)[] {
  const slopes = gradient.map((row, index) => (fixed.includes(index) ? 0 : Math.hypot(...row)));
  const steepest = Math.max(...slopes, 0);
  return gradient.map((row, index) =>
    slopes[index] > FLAT * steepest ? row.map((value) => -value / steepest + 0) : null,
  );
}

/** The adviser's value and the anchor that has most to gain, for those who do not see the arrows. */
export function toldAdvice(advice: Advice, { placement }: Scenario): string[] {
  const arrows = downhillOf(advice, placement.fixed);
  const most = arrows.findIndex((arrow) => arrow !== null && Math.hypot(...arrow) > 1 - FLAT);
  const value = `The placement counts ${formatValue(advice.value, advice.unit)}`;
  if (most < 0) return [`${value}.`];
  const direction = formatPoint(arrows[most]!.map((part) => Number(part.toFixed(2)))).replace(" m", "");
  return [`${value}; anchor ${most + 1} gains most, along ${direction}.`];
}

function rounded(value: number): number {
  return Number(value.toPrecision(3)) + 0;
}
