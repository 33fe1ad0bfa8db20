import { formatNumber, formatPoint } from "../controls/format";
import type { Scenario } from "../scenario";
import { addAnchor, coordinateStep, moveAnchor, removeAnchor, roundTo } from "./edit";
import type { Session } from "./session.svelte";

/** What one can do to an anchor, the same by pointer, key, card and table. */

const AXES = ["x", "y", "z"] as const;

export function axesOf(scenario: Scenario): readonly string[] {
  return AXES.slice(0, scenario.dimension);
}

/** Anchors that are drawn anew for every trial cannot be moved. */
export function movable(scenario: Scenario): boolean {
  return scenario.redraw_anchors === null;
}

/** A tenth of a room-sized coordinate: what an arrow key or a button adds. */
export function coarseStep(scenario: Scenario): number {
  return 10 * coordinateStep(scenario);
}

export function choose(session: Session, index: number): void {
  const anchors = session.scenario.anchors;
  if (index < 0 || index >= anchors.length) return;
  session.selectedAnchor = index;
  session.announcement = `Anchor ${index + 1} selected, at ${formatPoint(anchors[index])}.`;
}

export function chooseNext(session: Session, by: 1 | -1): void {
  const count = session.scenario.anchors.length;
  const from = session.selectedAnchor ?? (by > 0 ? -1 : count);
  choose(session, (from + by + count) % count);
}

/** Part of a drag or of a held key; `session.commit` ends it. */
export function dragTo(session: Session, index: number, point: readonly number[]): void {
  const { scenario } = session;
  const step = coordinateStep(scenario);
  const position = point.slice(0, scenario.dimension).map((value) => roundTo(value, step));
  const what = `Anchor ${index + 1} moved to ${formatPoint(position)}`;
  session.preview(what, moveAnchor(scenario, index, position));
}

export function nudge(session: Session, direction: readonly number[], fine: boolean): boolean {
  const { scenario, selectedAnchor: index } = session;
  if (index === null || !movable(scenario)) return false;
  const step = fine ? coordinateStep(scenario) : coarseStep(scenario);
  const moved = scenario.anchors[index].map((value, axis) => value + direction[axis] * step);
  dragTo(session, index, moved);
  return true;
}

export function place(session: Session, index: number, axis: number, value: number): boolean {
  const { scenario } = session;
  const position = scenario.anchors[index].map((old, i) => (i === axis ? value : old));
  const what = `Anchor ${index + 1}: ${AXES[axis]} set to ${formatNumber(value)} m`;
  return session.edit(what, moveAnchor(scenario, index, position));
}

export function add(session: Session): void {
  if (!movable(session.scenario) || !session.edit("Anchor added", addAnchor(session.scenario))) return;
  session.selectedAnchor = session.scenario.anchors.length - 1;
}

export function remove(session: Session, index: number): void {
  if (!movable(session.scenario)) return;
  if (session.edit(`Anchor ${index + 1} removed`, removeAnchor(session.scenario, index)))
    session.selectedAnchor = null;
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
