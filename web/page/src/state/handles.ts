import type { SceneDocument } from "../family";
import type { Shape } from "../scene/draw-list";

/** A thing of the scenario beside its anchors that is chosen and moved in the scene: an end of a wall, a corner of a box. */
export interface Handle<S extends SceneDocument = SceneDocument> {
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
  move(scenario: S, place: readonly number[]): S;
  /** What it is a part of and goes with, by name, and the scenario without that. */
  readonly whole?: { readonly name: string; without(scenario: S): S };
}

/** What one makes by drawing over the floor, from one place to another: a wall between its ends, a box over its corners. */
export interface Drawing<S extends SceneDocument = SceneDocument> {
  /** After "Draw": "a wall". */
  readonly name: string;
  readonly outline: "line" | "rectangle";
  /** `from` and `to` have the dimension of the scene, the heights of the floor and of the room's top. */
  make(scenario: S, from: readonly number[], to: readonly number[]): Drawn<S>;
}

export interface Drawn<S extends SceneDocument = SceneDocument> {
  readonly scenario: S;
  /** As a sentence begins: "Wall 2 drawn". */
  readonly what: string;
  /** The handle by which the new one is chosen. */
  readonly handle: string;
}

/** The start of the body, among the things of the scene. */
export const START = "start";
