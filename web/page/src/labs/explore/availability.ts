import type { Obstacle } from "../../generated/Obstacle";
import { boxOf } from "../../rigid-body/arrangements";
import type { Scenario } from "../../scenario";

/** Edits of which ranges can be measured, as pure functions. */

/** One anchor with another longest range, m; null where it has none. */
export function withLimit(scenario: Scenario, anchor: number, limit: number | null): Scenario {
  const { availability, anchors } = scenario;
  const limits = anchors.map((_, index) => availability.max_ranges[index] ?? null).with(anchor, limit);
  const max_ranges = limits.every((one) => one === null) ? [] : limits;
  return { ...scenario, availability: { ...availability, max_ranges } };
}

export function withObstacles(scenario: Scenario, obstacles: Obstacle[]): Scenario {
  return { ...scenario, availability: { ...scenario.availability, obstacles } };
}

/** A new wall or box where it is seen at once: between the body and the far side of the anchors along x. */
export function newObstacle({ anchors, start }: Scenario, kind: Obstacle["kind"]): Obstacle {
  const { least, most } = boxOf(anchors);
  const extent = most.map((value, axis) => value - least[axis]);
  const between = (axis: number, share: number) => rounded(least[axis] + share * extent[axis]);
  const x = rounded((start.position[0] + most[0]) / 2);
  if (kind === "wall")
    return { kind, from: [x, between(1, 0.3)], to: [x, between(1, 0.7)], bottom: null, top: null };
  const side = rounded(Math.max(0.1, 0.1 * extent[0]));
  const [low, high] = [
    [x, between(1, 0.4)],
    [rounded(x + side), rounded(Math.max(between(1, 0.6), between(1, 0.4) + side))],
  ];
  if (least.length === 2) return { kind, low, high };
  return {
    kind,
    low: [...low, least[2]],
    high: [...high, rounded(Math.max(between(2, 0.5), least[2] + side))],
  };
}

/** An obstacle with another number: at an index of one of its points, or at a height. */
export function withNumber(
  obstacle: Obstacle,
  key: string,
  index: number | null,
  value: number | null,
): Obstacle {
  const before = (obstacle as Record<string, unknown>)[key];
  const next = index === null ? value : (before as number[]).with(index, value!);
  return { ...obstacle, [key]: next };
}

function rounded(value: number): number {
  return Number(value.toPrecision(3)) + 0;
}
