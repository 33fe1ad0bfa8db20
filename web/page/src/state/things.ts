import { formatPoint } from "../controls/format";
import type { Family, Room, SceneDocument } from "../family";
import { lowerFirst, startOf } from "../words";
import { roundTo } from "./edit";
import type { Handle } from "./handles";

/** What one can choose and move in the scene: an anchor by its index, or a handle by its id. */
export type Thing = number | string;

/** Where things are, in metres; a scenario moves several at once. */
export type Places = ReadonlyMap<Thing, readonly number[]>;

/** The scenario whose things they are, and the lab that knows its handles. */
export interface Things<S extends SceneDocument = SceneDocument> {
  readonly scenario: S;
  readonly lab: { readonly family: Family<S>; handles?(scenario: S): readonly Handle<S>[] };
}

export function roomOf({ scenario, lab }: Things): Room {
  return lab.family.room(scenario);
}

/** What can be moved beside the anchors: the start of the body first, where it can. */
export function handlesOf<S extends SceneDocument>({ scenario, lab }: Things<S>): readonly Handle<S>[] {
  const start = lab.family.startHandle?.(scenario);
  return [...(start ? [start] : []), ...(lab.handles?.(scenario) ?? [])];
}

export function placeOf(things: Things, thing: Thing): readonly number[] {
  if (typeof thing === "number") return roomOf(things).anchors[thing];
  return handlesOf(things).find(({ id }) => id === thing)?.place ?? [];
}

export function placesOf(things: Things, chosen: Iterable<Thing>): Places {
  return new Map([...chosen].map((thing) => [thing, placeOf(things, thing)]));
}

/** The things that the scenario has; the same list where it has all of them. */
export function existing(things: Things, chosen: readonly Thing[]): readonly Thing[] {
  if (chosen.length === 0) return chosen;
  const handles = handlesOf(things);
  const { anchors } = roomOf(things);
  const there = chosen.filter((thing) =>
    typeof thing === "number" ? thing < anchors.length : handles.some(({ id }) => id === thing),
  );
  return there.length === chosen.length ? chosen : there;
}

/** Anchors that are drawn anew for every trial cannot be moved. */
export function movable(things: Things, thing: Thing): boolean {
  return typeof thing === "string" || roomOf(things).movable;
}

/** Twice over the handles: a corner stops at the opposite one, which may have been about to go on. */
export function putAt<S extends SceneDocument>(things: Things<S>, places: Places): S {
  const { scenario, lab } = things;
  const anchors = roomOf(things).anchors.map((anchor, index) => [...(places.get(index) ?? anchor)]);
  const moved = handlesOf(things).filter(({ id }) => places.has(id));
  return [...moved, ...moved].reduce(
    (next, handle) => handle.move(next, places.get(handle.id)!),
    lab.family.withAnchors(scenario, anchors),
  );
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

/** The height of the middle is that of those that have one. */
export function middleOf(all: readonly (readonly number[])[]): number[] {
  const axes = Math.max(...all.map((place) => place.length));
  return Array.from({ length: axes }, (_, axis) => {
    const values = all.filter((place) => axis < place.length).map((place) => place[axis]);
    return values.reduce((sum, value) => sum + value, 0) / values.length;
  });
}

export function nameOf(things: Things, chosen: readonly Thing[]): string {
  const anchors = chosen.filter((thing) => typeof thing === "number");
  const handles = handlesOf(things).filter(({ id }) => chosen.includes(id));
  const many = `${handles.length} handles`;
  const noun = things.lab.family.anchor;
  if (anchors.length === 0) return handles.length === 1 ? handles[0].name : many;
  const name = anchors.length === 1 ? `${startOf(noun)} ${anchors[0] + 1}` : `${anchors.length} ${noun}s`;
  if (handles.length === 0) return name;
  return `${name} and ${handles.length === 1 ? lowerFirst(handles[0].name) : many}`;
}

/** "Anchor 2 moved to (1, 2, 0) m", of things that are there now. */
export function moveSentence(things: Things, moved: readonly Thing[]): string {
  const places = placesOf(things, moved);
  if (moved.length > 1) return `${nameOf(things, moved)} moved, now around ${formatPoint(centroid(places))}`;
  return `${nameOf(things, moved)} moved to ${formatPoint(centroid(places))}${onto(things, places)}`;
}

/** What it means that an anchor now stands where there is one already; empty where there is none. */
export function onto(things: Things, places: Places): string {
  const { anchors } = roomOf(things);
  const noun = things.lab.family.anchor;
  for (const [thing, place] of places) {
    if (typeof thing === "string") continue;
    const under = anchors.findIndex(
      (anchor, index) => !places.has(index) && anchor.every((value, axis) => value === place[axis]),
    );
    if (under >= 0) return `, onto ${noun} ${under + 1}: together they count as one better ${noun}`;
  }
  return "";
}
