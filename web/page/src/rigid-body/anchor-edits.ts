import type { Scenario } from "../scenario";

/** Edits of the anchors of a scenario as pure functions: the old one stays as it was. */

export function addAnchors(scenario: Scenario, positions: readonly (readonly number[])[]): Scenario {
  return withAnchors(scenario, [...scenario.anchors, ...positions]);
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
export function withAnchors(scenario: Scenario, anchors: readonly (readonly number[])[]): Scenario {
  const { availability, placement } = scenario;
  const limits = availability.max_ranges;
  const max_ranges = limits.length === 0 ? [] : anchors.map((_, index) => limits[index] ?? null);
  return {
    ...scenario,
    anchors: anchors.map((anchor) => [...anchor]),
    availability: { ...availability, max_ranges },
    placement: { ...placement, fixed: placement.fixed.filter((index) => index < anchors.length) },
  };
}
