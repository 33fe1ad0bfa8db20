import type { Thing } from "../state/things";
import { type Camera, orbit, pan, zoomTo } from "./camera";
import type { Vec3 } from "./geometry";
import type { Pickable } from "./picking";
import type { Pixel, View } from "./view";

/** What the pointer may look at and change. */
export interface SceneHands {
  view(): View;
  /** Seen from above only: a drag beside the things moves the scene instead of turning it. */
  planar(): boolean;
  pickable(): Pickable;
  selected(): readonly Thing[];
  /** Anchors that are drawn anew for every trial cannot be dragged. */
  movable(thing: Thing): boolean;
  /** Whether it has a height that can be changed. */
  lifts(thing: Thing): boolean;
  tool(): Tool;
  /** Farthest that a thing is dragged at once, and the spacing of the grid, in metres. */
  dragLimit(): number;
  gridSpacing(): number;
  setCamera(camera: Camera): void;
  hover(thing: Thing | null, pixel: Pixel): void;
  leave(): void;
  select(things: readonly Thing[]): void;
  toggle(thing: Thing): void;
  /** What is chosen is now this far from where the drag began. */
  move(shift: Vec3, event: PointerEvent): void;
  /** Shows what is drawn from one place on the floor to another, with the grid's spacing or free. */
  draw(from: Pixel, to: Pixel, snaps: boolean): void;
  /** Takes what was dragged or drawn. */
  drop(): void;
  takeBack(): void;
  /** The rectangle that is being drawn around things. */
  frameThings(corners: readonly [Pixel, Pixel] | null): void;
  selectInside(corners: readonly [Pixel, Pixel]): void;
  /** A click beside the things. */
  clickBeside(pixel: Pixel): void;
  doubleClick(pixel: Pixel, thing: Thing | null): void;
}

/** Turning and moving; choosing several; waiting for the place where the chosen ones shall go; drawing. */
export type Tool = "move" | "several" | "destination" | "draw";

/** What one pointer does from when it goes down to when it comes up. */
export interface Gesture {
  move(before: Pixel, now: Pixel, event: PointerEvent): void;
  end(): void;
  cancel(): void;
}

const RADIANS_PER_PIXEL = 0.008;

/** Drags what is chosen; `follow` knows the way from pixels to metres, Ctrl snaps to the grid. */
export function dragThings(hands: SceneHands, follow: (pixel: Pixel, snap: number | null) => Vec3): Gesture {
  return {
    move: (_, now, event) => {
      const snap = event.ctrlKey || event.metaKey ? hands.gridSpacing() : null;
      hands.move(follow(now, snap), event);
    },
    end: () => hands.drop(),
    cancel: () => hands.takeBack(),
  };
}

/** Draws a new thing over the floor; Ctrl snaps to the grid. */
export function drawThing(hands: SceneHands, from: Pixel): Gesture {
  return {
    move: (_, now, event) => hands.draw(from, now, event.ctrlKey || event.metaKey),
    end: () => hands.drop(),
    cancel: () => hands.takeBack(),
  };
}

export function moveCamera(hands: SceneHands, kind: "turn" | "pan"): Gesture {
  return {
    move: (before, now) => {
      const { camera, viewport } = hands.view();
      const [dx, dy] = [now.x - before.x, now.y - before.y];
      hands.setCamera(
        kind === "pan"
          ? pan(camera, dx, dy, viewport)
          : orbit(camera, -dx * RADIANS_PER_PIXEL, dy * RADIANS_PER_PIXEL),
      );
    },
    end: () => {},
    cancel: () => {},
  };
}

/** Draws a rectangle and chooses what is in it. */
export function frameThings(hands: SceneHands, from: Pixel): Gesture {
  let to = from;
  return {
    move: (_, now) => {
      to = now;
      hands.frameThings([from, to]);
    },
    end: () => {
      hands.frameThings(null);
      hands.selectInside([from, to]);
    },
    cancel: () => hands.frameThings(null),
  };
}

/** Two fingers: their middle moves the scene, their distance stretches it there, their angle turns it. */
export function pinched(
  view: View,
  planar: boolean,
  old: readonly [Pixel, Pixel],
  now: readonly [Pixel, Pixel],
): Camera {
  const [before, after] = [span(old), span(now)];
  const moved = pan(view.camera, after.x - before.x, after.y - before.y, view.viewport);
  const turned = planar ? moved : orbit(moved, after.angle - before.angle, 0);
  return zoomTo({ camera: turned, viewport: view.viewport }, after, after.length / before.length);
}

function span([a, b]: readonly [Pixel, Pixel]): Pixel & { readonly length: number; readonly angle: number } {
  return {
    x: (a.x + b.x) / 2,
    y: (a.y + b.y) / 2,
    length: Math.max(1, Math.hypot(b.x - a.x, b.y - a.y)),
    angle: Math.atan2(b.y - a.y, b.x - a.x),
  };
}
