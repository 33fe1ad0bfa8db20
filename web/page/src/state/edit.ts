import type { Scenario } from "../scenario";

/** Edits of a scenario as pure functions: the old one stays as it was. */

export function addAnchors(scenario: Scenario, positions: readonly (readonly number[])[]): Scenario {
  return withAnchors(scenario, [...scenario.anchors, ...positions.map((position) => [...position])]);
}

export function removeAnchors(scenario: Scenario, indices: readonly number[]): Scenario {
  const { anchors, availability, placement } = scenario;
  const stays = (_: unknown, index: number) => !indices.includes(index);
  const renumbered = (index: number) => index - indices.filter((removed) => removed < index).length;
  return {
    ...scenario,
    anchors: anchors.filter(stays),
    availability: { ...availability, max_ranges: availability.max_ranges.filter(stays) },
    placement: {
      ...placement,
      fixed: placement.fixed.filter((index) => !indices.includes(index)).map(renumbered),
    },
  };
}

/** The scenario with other anchors in place of its own: those that are new have no limit of range and may move. */
export function withAnchors(scenario: Scenario, anchors: number[][]): Scenario {
  const { availability, placement } = scenario;
  const limits = availability.max_ranges;
  const max_ranges = limits.length === 0 ? [] : anchors.map((_, index) => limits[index] ?? null);
  return {
    ...scenario,
    anchors,
    availability: { ...availability, max_ranges },
    placement: { ...placement, fixed: placement.fixed.filter((index) => index < anchors.length) },
  };
}

export function setEstimatorEnabled(
  scenario: Scenario,
  name: string,
  enabled: boolean,
  order: readonly string[],
): Scenario {
  const wanted = new Set<string>(scenario.estimators.enabled);
  if (enabled) wanted.add(name);
  else wanted.delete(name);
  const list = order.filter((entry) => wanted.has(entry)) as Scenario["estimators"]["enabled"];
  return { ...scenario, estimators: { ...scenario.estimators, enabled: list } };
}

/** Smallest step of ten that is below a thousandth of the scene: dragged coordinates are rounded to it. */
export function coordinateStep(scenario: Scenario): number {
  const extent = Math.max(1e-3, ...scenario.anchors.flat().map(Math.abs));
  return 10 ** Math.floor(Math.log10(extent / 200));
}

export function roundTo(value: number, step: number): number {
  const digits = Math.max(0, -Math.floor(Math.log10(step)));
  // Adding 0 turns -0, which JSON does not know, into 0.
  return Number((Math.round(value / step) * step).toFixed(digits)) + 0;
}

/** Where a new anchor helps to be seen: above the middle of the others, off their plane. */
export function newAnchorPosition(scenario: Scenario): number[] {
  const step = coordinateStep(scenario);
  const count = Math.max(1, scenario.anchors.length);
  const extent = Math.max(1, ...scenario.anchors.flat().map(Math.abs));
  return Array.from({ length: scenario.dimension }, (_, axis) => {
    const mean = scenario.anchors.reduce((sum, anchor) => sum + anchor[axis], 0) / count;
    const offset = axis === scenario.dimension - 1 ? 0.5 * extent : 0.1 * extent * ((count % 3) - 1);
    return roundTo(mean + offset, step);
  });
}
