import type { Obstacle } from "../../generated/Obstacle";
import type { Region } from "../../generated/Region";
import type { Scenario } from "../../scenario";
import { withObstacles } from "./availability";
import { withPlacement } from "./placement";

type Wall = Extract<Obstacle, { kind: "wall" }>;

/** A box or a wall of the scenario, wherever in it that stands. */
export interface Part<T> {
  readonly id: string;
  /** As it stands in a sentence: "keep out 1". */
  readonly name: string;
  /** The design token of its colour. */
  readonly token: string;
  /** Lengths of the dashes of its edges; 0 for full lines. */
  readonly dash: number;
  of(scenario: Scenario): T;
  set(scenario: Scenario, next: T): Scenario;
  without(scenario: Scenario): Scenario;
}

export function limitsPart(): Part<Region> {
  return {
    id: "limits",
    name: "anchors within",
    token: "ink-soft",
    dash: 0,
    of: ({ placement }) => placement.limits!,
    set: (scenario, limits) => withPlacement(scenario, { limits }),
    without: (scenario) => withPlacement(scenario, { limits: null }),
  };
}

export function regionPart(): Part<Region> {
  return {
    id: "region",
    name: "body within",
    token: "accent",
    dash: 6,
    of: ({ placement }) => placement.region!,
    set: (scenario, region) => withPlacement(scenario, { region }),
    without: (scenario) => withPlacement(scenario, { region: null }),
  };
}

export function keepOutPart(index: number): Part<Region> {
  const all = ({ placement }: Scenario) => placement.keep_out;
  return {
    id: `keep-out-${index}`,
    name: `keep out ${index + 1}`,
    token: "warning",
    dash: 3,
    of: (scenario) => all(scenario)[index],
    set: (scenario, box) => withPlacement(scenario, { keep_out: put(all(scenario), index, box) }),
    without: (scenario) => withPlacement(scenario, { keep_out: all(scenario).toSpliced(index, 1) }),
  };
}

/** Obstacles are numbered together, as in the controls. */
function obstaclePart<T extends Obstacle>(index: number, kind: T["kind"]): Part<T> {
  const all = ({ availability }: Scenario) => availability.obstacles;
  return {
    id: `obstacle-${index}`,
    name: `${kind} ${index + 1}`,
    token: "ink-soft",
    dash: 0,
    of: (scenario) => all(scenario)[index] as T,
    set: (scenario, next) => withObstacles(scenario, put(all(scenario), index, next)),
    without: (scenario) => withObstacles(scenario, all(scenario).toSpliced(index, 1)),
  };
}

export function wallPart(index: number): Part<Wall> {
  return obstaclePart<Wall>(index, "wall");
}

export function obstacleBoxPart(index: number): Part<Region> {
  const part = obstaclePart<Extract<Obstacle, { kind: "box" }>>(index, "box");
  return { ...part, set: (scenario, { low, high }) => part.set(scenario, { kind: "box", low, high }) };
}

/** The boxes that limit where the body and the anchors may be. */
export function placementParts({ placement }: Scenario): Part<Region>[] {
  return [
    ...(placement.region ? [regionPart()] : []),
    ...(placement.limits ? [limitsPart()] : []),
    ...placement.keep_out.map((_, index) => keepOutPart(index)),
  ];
}

/** The list with another entry at an index, also at its end. */
function put<T>(list: readonly T[], index: number, entry: T): T[] {
  return [...list.slice(0, index), entry, ...list.slice(index + 1)];
}
