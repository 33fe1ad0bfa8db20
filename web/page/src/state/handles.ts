import type { Scenario } from "../scenario";
import type { Shape } from "../scene/draw-list";

/** A thing of the scenario beside its anchors that is chosen and moved in the scene: an end of a wall, a corner of a box. */
export interface Handle {
  /** The same from edit to edit. */
  readonly id: string;
  /** As a sentence begins: "Keep out 1, low corner". */
  readonly name: string;
  /** m; x and y alone where the scene has a height and the thing cannot change its own. */
  readonly place: readonly number[];
  /** The height that such a thing is drawn at, m; on the floor by default. */
  readonly level?: number;
  readonly mark: Shape;
  /** The design token of its colour. */
  readonly token: string;
  /** The scenario with the thing there, or as near as it may go. */
  move(scenario: Scenario, place: readonly number[]): Scenario;
  /** What it is a part of and goes with, by name, and the scenario without that. */
  readonly whole?: { readonly name: string; without(scenario: Scenario): Scenario };
}

/** What one makes by drawing over the floor, from one place to another: a wall between its ends, a box over its corners. */
export interface Drawing {
  /** After "Draw": "a wall". */
  readonly name: string;
  readonly outline: "line" | "rectangle";
  /** `from` and `to` have the dimension of the scene, the heights of the floor and of the room's top. */
  make(scenario: Scenario, from: readonly number[], to: readonly number[]): Drawn;
}

export interface Drawn {
  readonly scenario: Scenario;
  /** As a sentence begins: "Wall 2 drawn". */
  readonly what: string;
  /** The handle by which the new one is chosen. */
  readonly handle: string;
}

export const START = "start";

/** Where the body starts, in every lab. */
export function startHandle({ start }: Scenario): Handle {
  return {
    id: START,
    name: "Start of the body",
    place: start.position,
    mark: "disc",
    token: "anchor",
    move: (scenario, place) => ({ ...scenario, start: { ...scenario.start, position: [...place] } }),
  };
}
