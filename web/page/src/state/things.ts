import { formatPoint } from "../controls/format";
import type { Scenario } from "../scenario";
import { roundTo } from "./edit";

/** What one can choose and move in the scene: an anchor, by its index, or where the body starts. */
export type Thing = number | "start";

/** Where things are, in metres; a scenario moves several at once. */
export type Places = ReadonlyMap<Thing, readonly number[]>;

export function placeOf(scenario: Scenario, thing: Thing): readonly number[] {
  return thing === "start" ? scenario.start.position : scenario.anchors[thing];
}

export function placesOf(scenario: Scenario, things: readonly Thing[]): Places {
  return new Map(things.map((thing) => [thing, placeOf(scenario, thing)]));
}

/** The things that the scenario has. */
export function existing(scenario: Scenario, things: readonly Thing[]): readonly Thing[] {
  return things.filter((thing) => thing === "start" || thing < scenario.anchors.length);
}

/** Anchors that are drawn anew for every trial cannot be moved. */
export function movable(scenario: Scenario, thing: Thing): boolean {
  return thing === "start" || scenario.redraw_anchors === null;
}

export function putAt(scenario: Scenario, places: Places): Scenario {
  const start = places.get("start");
  return {
    ...scenario,
    anchors: scenario.anchors.map((anchor, index) => [...(places.get(index) ?? anchor)]),
    start: start ? { ...scenario.start, position: [...start] } : scenario.start,
  };
}

/** All places moved the same way, rounded to `step`. */
export function shifted(places: Places, shift: readonly number[], step: number): Places {
  return new Map(
    [...places].map(([thing, place]) => [thing, place.map((value, i) => roundTo(value + shift[i], step))]),
  );
}

export function centroid(places: Places): number[] {
  return middleOf([...places.values()]);
}

export function middleOf(all: readonly (readonly number[])[]): number[] {
  return all[0].map((_, axis) => all.reduce((sum, place) => sum + place[axis], 0) / all.length);
}

export function nameOf(things: readonly Thing[]): string {
  const anchors = things.filter((thing) => thing !== "start");
  if (anchors.length === 0) return "Start of the body";
  const name = anchors.length === 1 ? `Anchor ${anchors[0] + 1}` : `${anchors.length} anchors`;
  return anchors.length < things.length ? `${name} and the start of the body` : name;
}

/** "Anchor 2 moved to (1, 2, 0) m". */
export function moveSentence(scenario: Scenario, places: Places): string {
  const things = [...places.keys()];
  if (things.length > 1) return `${nameOf(things)} moved, now around ${formatPoint(centroid(places))}`;
  return `${nameOf(things)} moved to ${formatPoint(centroid(places))}${onto(scenario, places)}`;
}

/** What it means that an anchor now stands where there is one already; empty where there is none. */
export function onto(scenario: Scenario, places: Places): string {
  for (const [thing, place] of places) {
    if (thing === "start") continue;
    const under = scenario.anchors.findIndex(
      (anchor, index) => !places.has(index) && anchor.every((value, axis) => value === place[axis]),
    );
    if (under >= 0) return `, onto anchor ${under + 1}: together they count as one better anchor`;
  }
  return "";
}
