import { complete, validate } from "../engine";
import type { Family } from "../family";
import type { Scenario } from "../scenario";
import { START } from "../state/handles";
import { removeAnchors, withAnchors } from "./anchor-edits";

/** A rigid body with sensors, ranged from anchors. */
export const rigidBody: Family<Scenario> = {
  name: "rigid body",
  anchor: "anchor",
  body: "body",
  claims: (document) => "anchors" in document,
  validate,
  complete,
  room: ({ dimension, anchors, redraw_anchors, start, sensors }) => ({
    dimension,
    anchors,
    movable: redraw_anchors === null,
    start: start.position,
    body: sensors,
  }),
  withAnchors,
  withoutAnchors: removeAnchors,
  startHandle: ({ start }) => ({
    id: START,
    name: "Start of the body",
    place: start.position,
    mark: "disc",
    token: "anchor",
    move: (scenario, place) => ({ ...scenario, start: { ...scenario.start, position: [...place] } }),
  }),
};
