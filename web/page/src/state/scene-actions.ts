import { formatNumber, formatPoint } from "../controls/format";
import type { Room } from "../family";
import { lowerFirst, startOf } from "../words";
import { coordinateStep, newAnchorPosition, roundTo } from "./edit";
import type { Session } from "./session.svelte";
import type { Handle } from "./handles";
import {
  centroid,
  handlesOf,
  movable,
  moveSentence,
  nameOf,
  onto,
  type Places,
  placeOf,
  placesOf,
  putAt,
  shifted,
  type Thing,
} from "./things";

/** What one can do to the things of the scene, the same by pointer, key, card and table. */

const AXES = ["x", "y", "z"] as const;

export function axesOf({ dimension }: Pick<Room, "dimension">): readonly string[] {
  return AXES.slice(0, dimension);
}

/** A tenth of a room-sized coordinate: what an arrow key or a button adds. */
export function coarseStep(room: Pick<Room, "anchors">): number {
  return 10 * coordinateStep(room);
}

/** The chosen things that may be moved, and where they are. */
export function movablePlaces(session: Session): Places {
  return placesOf(
    session,
    session.selected.filter((thing) => movable(session, thing)),
  );
}

export function select(session: Session, things: readonly Thing[]): void {
  session.selected = things;
  if (things.length === 0) return;
  const where = things.length === 1 ? `, at ${formatPoint(placeOf(session, things[0]))}` : "";
  session.announcement = `${nameOf(session, things)} selected${where}.`;
}

/** Adds to what is chosen, or takes out of it. */
export function toggle(session: Session, thing: Thing): void {
  const { selected } = session;
  const without = selected.filter((other) => other !== thing);
  select(session, without.length < selected.length ? without : [...selected, thing]);
}

/** Through the anchors and the handles, and round again. */
export function selectNext(session: Session, by: 1 | -1): void {
  const handles = handlesOf(session).map(({ id }) => id);
  const all: Thing[] = [...session.room.anchors.keys(), ...handles];
  const last = session.selected.at(-1);
  const from = last === undefined ? (by > 0 ? -1 : all.length) : all.indexOf(last);
  select(session, [all[(from + by + all.length) % all.length]]);
}

export function selectAll(session: Session): void {
  select(session, [...session.room.anchors.keys()]);
}

/** Part of a drag or of a held key: everything moves by `shift` from where it was; `session.commit` ends it. */
export function shiftBy(session: Session, places: Places, shift: readonly number[]): void {
  if (places.size === 0) return;
  const scenario = putAt(session, shifted(places, shift, coordinateStep(session.room)));
  session.preview(moveSentence({ scenario, lab: session.lab }, [...places.keys()]), scenario);
}

export function nudge(session: Session, direction: readonly number[], fine: boolean): boolean {
  const places = movablePlaces(session);
  if (places.size === 0) return false;
  const along = direction.slice(0, centroid(places).length);
  if (along.every((value) => value === 0)) return false;
  const step = fine ? coordinateStep(session.room) : coarseStep(session.room);
  shiftBy(
    session,
    places,
    along.map((value) => value * step),
  );
  return true;
}

/** Moves things so that their middle has the given coordinate. One alone gets exactly what was typed. */
export function place(session: Session, things: readonly Thing[], axis: number, value: number): boolean {
  const places = placesOf(session, things);
  const change = value - centroid(places)[axis];
  const moved = new Map(
    [...places].map(([thing, at]) => {
      if (axis >= at.length) return [thing, at];
      return [thing, at.with(axis, places.size === 1 ? value : at[axis] + change)];
    }),
  );
  const scenario = putAt(session, moved);
  const now = centroid(placesOf({ scenario, lab: session.lab }, things))[axis];
  const what = `${nameOf(session, things)}: ${AXES[axis]} set to ${formatNumber(now)} m${onto(session, moved)}`;
  return session.edit(what, scenario);
}

/** Moves what is chosen so that its middle lies at a point, or level with its height where the point has none. */
export function moveTo(session: Session, point: readonly number[]): boolean {
  const places = movablePlaces(session);
  if (places.size === 0) return false;
  const shift = centroid(places).map((from, axis) => (point[axis] ?? from) - from);
  shiftBy(session, places, shift);
  return session.commit();
}

/** Adds an anchor at a point, or where it helps to be seen. */
export function add(session: Session, point?: readonly number[]): void {
  if (!movable(session, 0)) return;
  const { room, lab } = session;
  const step = coordinateStep(room);
  const at = point?.slice(0, room.dimension).map((value) => roundTo(value, step)) ?? newAnchorPosition(room);
  const name = `${startOf(lab.family.anchor)} ${room.anchors.length + 1}`;
  addAll(session, `${name} added at ${formatPoint(at)}`, [at]);
}

/** Copies of the chosen anchors, one coarse step beside them. */
export function duplicate(session: Session): void {
  const { room } = session;
  const chosen = anchorsOf(session);
  if (chosen.length === 0 || !movable(session, chosen[0])) return;
  const beside = axesOf(room).map((_, axis) => (axis === 0 ? 5 * coarseStep(room) : 0));
  const copies = [...shifted(placesOf(session, chosen), beside, coordinateStep(room)).values()];
  addAll(session, `${nameOf(session, chosen)} duplicated`, copies);
}

/** Adds anchors and chooses them. */
function addAll(session: Session, what: string, places: readonly (readonly number[])[]): void {
  const { scenario, lab, room } = session;
  const next = lab.family.withAnchors(scenario, [...room.anchors, ...places]);
  if (session.edit(what, next)) session.selected = places.map((_, i) => room.anchors.length + i);
}

export function remove(session: Session, indices: readonly number[]): void {
  if (indices.length === 0 || !movable(session, indices[0])) return;
  const next = session.lab.family.withoutAnchors(session.scenario, indices);
  if (session.edit(`${nameOf(session, indices)} removed`, next)) session.selected = [];
}

/** Removes the anchors among what is chosen, and the boxes and walls that have a handle there. */
export function removeChosen(session: Session): void {
  const { scenario, lab } = session;
  const anchors = movable(session, 0) ? anchorsOf(session) : [];
  const wholes = wholesOf(session);
  if (anchors.length + wholes.length === 0) return;
  const names = [
    ...(anchors.length > 0 ? [nameOf(session, anchors)] : []),
    ...wholes.map(({ name }) => name),
  ];
  const what = new Intl.ListFormat("en-GB").format(
    names.map((name, i) => (i === 0 ? name : lowerFirst(name))),
  );
  const kept = anchors.length > 0 ? lab.family.withoutAnchors(scenario, anchors) : scenario;
  // From the last: those before it keep their numbers.
  const without = wholes.reduceRight((next, whole) => whole.without(next), kept);
  if (session.edit(`${what} removed`, without)) session.selected = [];
}

/** The anchors among what is chosen. */
export function anchorsOf({ selected }: Session): number[] {
  return selected.filter((thing) => typeof thing === "number");
}

/** The boxes and walls that have a handle among what is chosen, each once. */
export function wholesOf(session: Session): NonNullable<Handle["whole"]>[] {
  const chosen = handlesOf(session).filter(({ id }) => session.selected.includes(id));
  const wholes = chosen.flatMap(({ whole }) => whole ?? []);
  return wholes.filter(({ name }, index) => wholes.findIndex((other) => other.name === name) === index);
}
