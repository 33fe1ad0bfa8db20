import { formatNumber, formatPoint } from "../controls/format";
import type { Scenario } from "../scenario";
import { addAnchors, coordinateStep, newAnchorPosition, removeAnchors, roundTo } from "./edit";
import type { Session } from "./session.svelte";
import {
  centroid,
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

export function axesOf(scenario: Scenario): readonly string[] {
  return AXES.slice(0, scenario.dimension);
}

/** A tenth of a room-sized coordinate: what an arrow key or a button adds. */
export function coarseStep(scenario: Scenario): number {
  return 10 * coordinateStep(scenario);
}

/** The chosen things that may be moved, and where they are. */
export function movablePlaces({ scenario, selected }: Session): Places {
  return placesOf(
    scenario,
    selected.filter((thing) => movable(scenario, thing)),
  );
}

export function select(session: Session, things: readonly Thing[]): void {
  session.selected = things;
  const { scenario } = session;
  if (things.length === 0) return;
  const where = things.length === 1 ? `, at ${formatPoint(placeOf(scenario, things[0]))}` : "";
  session.announcement = `${nameOf(things)} selected${where}.`;
}

/** Adds to what is chosen, or takes out of it. */
export function toggle(session: Session, thing: Thing): void {
  const { selected } = session;
  const without = selected.filter((other) => other !== thing);
  select(session, without.length < selected.length ? without : [...selected, thing]);
}

/** Through the anchors and the start of the body, and round again. */
export function selectNext(session: Session, by: 1 | -1): void {
  const all: Thing[] = [...session.scenario.anchors.keys(), "start"];
  const last = session.selected.at(-1);
  const from = last === undefined ? (by > 0 ? -1 : all.length) : all.indexOf(last);
  select(session, [all[(from + by + all.length) % all.length]]);
}

export function selectAll(session: Session): void {
  select(session, [...session.scenario.anchors.keys()]);
}

/** Part of a drag or of a held key: everything moves by `shift` from where it was; `session.commit` ends it. */
export function shiftBy(session: Session, places: Places, shift: readonly number[]): void {
  if (places.size === 0) return;
  const moved = shifted(places, shift, coordinateStep(session.scenario));
  session.preview(moveSentence(session.scenario, moved), putAt(session.scenario, moved));
}

export function nudge(session: Session, direction: readonly number[], fine: boolean): boolean {
  const places = movablePlaces(session);
  const along = direction.slice(0, session.scenario.dimension);
  if (places.size === 0 || along.every((value) => value === 0)) return false;
  const step = fine ? coordinateStep(session.scenario) : coarseStep(session.scenario);
  shiftBy(
    session,
    places,
    along.map((value) => value * step),
  );
  return true;
}

/** Moves things so that their middle has the given coordinate. One alone gets exactly what was typed. */
export function place(session: Session, things: readonly Thing[], axis: number, value: number): boolean {
  const places = placesOf(session.scenario, things);
  const change = value - centroid(places)[axis];
  const moved = new Map(
    [...places].map(([thing, at]) => {
      const coordinate = places.size === 1 ? value : at[axis] + change;
      return [thing, at.with(axis, coordinate)];
    }),
  );
  const what = `${nameOf(things)}: ${AXES[axis]} set to ${formatNumber(value)} m${onto(session.scenario, moved)}`;
  return session.edit(what, putAt(session.scenario, moved));
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
  const { scenario } = session;
  if (!movable(scenario, 0)) return;
  const step = coordinateStep(scenario);
  const at =
    point?.slice(0, scenario.dimension).map((value) => roundTo(value, step)) ?? newAnchorPosition(scenario);
  if (
    session.edit(
      `Anchor ${scenario.anchors.length + 1} added at ${formatPoint(at)}`,
      addAnchors(scenario, [at]),
    )
  )
    session.selected = [scenario.anchors.length];
}

/** Copies of the chosen anchors, one coarse step beside them. */
export function duplicate(session: Session): void {
  const { scenario } = session;
  const chosen = anchorsOf(session);
  if (chosen.length === 0 || !movable(scenario, chosen[0])) return;
  const beside = axesOf(scenario).map((_, axis) => (axis === 0 ? 5 * coarseStep(scenario) : 0));
  const copies = [...shifted(placesOf(scenario, chosen), beside, coordinateStep(scenario)).values()];
  const what = `${nameOf(chosen)} duplicated`;
  if (session.edit(what, addAnchors(scenario, copies)))
    session.selected = copies.map((_, i) => scenario.anchors.length + i);
}

export function remove(session: Session, indices: readonly number[]): void {
  const { scenario } = session;
  if (indices.length === 0 || !movable(scenario, indices[0])) return;
  if (session.edit(`${nameOf(indices)} removed`, removeAnchors(scenario, indices))) session.selected = [];
}

/** The anchors among what is chosen. */
export function anchorsOf({ selected }: Session): number[] {
  return selected.filter((thing) => thing !== "start");
}

/** Makes the anchors that this trial drew the scenario's own. */
export function keepDrawn(session: Session): void {
  const anchors = session.run?.anchors ?? session.scenario.anchors;
  session.edit("Anchors kept as this trial drew them", {
    ...session.scenario,
    anchors,
    redraw_anchors: null,
  });
}
