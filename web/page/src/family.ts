import type { Complaint } from "./engine";
import type { Handle } from "./state/handles";

/** What every document has, whatever it describes. */
export interface SceneDocument {
  version: number;
  name: string;
  seed: number;
  view: Record<string, unknown> | null;
}

/** What the frame reads of a document of any kind: what stands in the room, and the body in it; metres. */
export interface Room {
  readonly dimension: number;
  readonly anchors: readonly (readonly number[])[];
  /** False where anchors are drawn anew for every trial and cannot be moved. */
  readonly movable: boolean;
  /** Where the body starts, and the points of it that are ranged, in its own frame. */
  readonly start: readonly number[];
  readonly body: readonly (readonly number[])[];
  /** Where the body is no rigid one: all that a view of it shows, as places in the room. */
  readonly extent?: readonly (readonly number[])[];
}

/**
 * A kind of documents: how they are read, and how the frame changes what all kinds have in common. Labs of one family can
 * show each other's scenes: going from one to another keeps the scene.
 */
export interface Family<S extends SceneDocument = SceneDocument> {
  readonly name: string;
  /** What its documents call an anchor: "anchor", "beacon". */
  readonly anchor: string;
  /** What they call what moves among them: "body", "network". */
  readonly body: string;
  /** Brings what reading a document needs besides the page itself; a family without it can read at once. */
  load?(): Promise<void>;
  /** Whether a document that names no lab is one of these. */
  claims(document: object): boolean;
  /** All that is wrong with a document. */
  validate(document: unknown): Complaint[];
  /** The document with everything filled in that it leaves out. Throws an `Error` with a sentence. */
  complete(document: unknown): S;
  room(scenario: S): Room;
  withAnchors(scenario: S, anchors: readonly (readonly number[])[]): S;
  withoutAnchors(scenario: S, indices: readonly number[]): S;
  /** The start of the body, where it can be chosen and moved. */
  startHandle?(scenario: S): Handle<S>;
}
