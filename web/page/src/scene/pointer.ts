import { zoomTo } from "./camera";
import { startDrag } from "./drag";
import {
  dragThings,
  drawThing,
  frameThings,
  type Gesture,
  moveCamera,
  pinched,
  type SceneHands,
} from "./gestures";
import type { Thing } from "../state/things";
import { type Hit, pickAll } from "./picking";
import type { Pixel } from "./view";

/** CSS pixels a pointer may tremble and still be a click. */
const CLICK_SLACK = { mouse: 4, touch: 10 };
/** Two clicks are one double click within this time and distance. */
const DOUBLE = { milliseconds: 400, pixels: 24 };

/** CSS pixels between things of which one lies on the other. */
const COVERED = 6;

interface Press {
  readonly at: Pixel;
  readonly hit: Hit | null;
  readonly gesture: Gesture;
  readonly touch: boolean;
  /** What was chosen before it. */
  readonly was: readonly Thing[];
  /** Ctrl or the tool: a click takes a thing out of what is chosen if it was there before. */
  readonly takesOut: boolean;
  /** A button that never clicks, as the right one. */
  readonly silent: boolean;
  moved: boolean;
}

/**
 * One pointer on a thing drags what is chosen (Shift: up and down; Ctrl: to the grid), elsewhere it turns the scene.
 * Shift, the right or the middle button move the scene, the wheel goes nearer, two fingers move, turn and stretch.
 */
export class PointerControl {
  readonly #element: HTMLElement;
  readonly #hands: SceneHands;
  readonly #places = new Map<number, Pixel>();
  #press: Press | null = null;
  #lastClick = { time: -Infinity, at: { x: 0, y: 0 } };

  constructor(element: HTMLElement, hands: SceneHands) {
    this.#element = element;
    this.#hands = hands;
    element.addEventListener("pointerdown", this.#down);
    element.addEventListener("pointermove", this.#move);
    element.addEventListener("pointerup", this.#up);
    element.addEventListener("pointercancel", (event) => {
      this.#places.delete(event.pointerId);
      this.cancel();
    });
    element.addEventListener("pointerleave", () => hands.leave());
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("wheel", this.#wheel, { passive: false });
  }

  /** Takes back what the pointer is doing; false where it does nothing. */
  cancel(): boolean {
    if (!this.#press?.moved) return false;
    this.#press.gesture.cancel();
    this.#press = null;
    return true;
  }

  #pixel(event: PointerEvent | WheelEvent): Pixel {
    const box = this.#element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  /** Things under the pointer, unless the tool asks for places. */
  #hits(event: PointerEvent): Hit[] {
    const touch = event.pointerType === "touch";
    const hands = this.#hands;
    if (hands.tool() === "destination" || hands.tool() === "draw") return [];
    return pickAll(hands.view(), hands.pickable(), { ...this.#pixel(event), touch });
  }

  #down = (event: PointerEvent): void => {
    this.#places.set(event.pointerId, this.#pixel(event));
    this.#element.setPointerCapture(event.pointerId);
    if (this.#places.size > 1) return this.#release();
    const several = event.ctrlKey || event.metaKey || this.#hands.tool() === "several";
    const hit = (event.button === 0 ? this.#hits(event)[0] : undefined) ?? null;
    const was = this.#hands.selected();
    const chosen = hit !== null && was.includes(hit.thing);
    if (hit && !chosen) this.#hands.select(several ? [...was, hit.thing] : [hit.thing]);
    this.#press = {
      at: this.#pixel(event),
      hit,
      gesture: this.#gesture(event, hit, several),
      touch: event.pointerType === "touch",
      was,
      takesOut: several && chosen,
      silent: event.button !== 0,
      moved: false,
    };
  };

  #gesture(event: PointerEvent, hit: Hit | null, several: boolean): Gesture {
    const hands = this.#hands;
    if (hands.tool() === "draw" && event.button === 0) return drawThing(hands, this.#pixel(event));
    if (hit === null || !hands.movable(hit.thing)) {
      if (event.button === 0 && several) return frameThings(hands, this.#pixel(event));
      const pans = hands.planar() || event.button !== 0 || event.shiftKey;
      return moveCamera(hands, pans ? "pan" : "turn");
    }
    const mode = hit.lifter || (event.shiftKey && hands.lifts(hit.thing)) ? "height" : "plane";
    const start = hands.pickable().points.get(hit.thing) ?? [0, 0, 0];
    return dragThings(hands, startDrag(hands.view(), start, this.#pixel(event), mode, hands.dragLimit()));
  }

  #move = (event: PointerEvent): void => {
    const now = this.#pixel(event);
    const before = this.#places.get(event.pointerId);
    if (!before) return this.#hands.hover(this.#hits(event)[0]?.thing ?? null, now);
    const other = [...this.#places].find(([id]) => id !== event.pointerId)?.[1];
    this.#places.set(event.pointerId, now);
    if (other) {
      const hands = this.#hands;
      return hands.setCamera(pinched(hands.view(), hands.planar(), [other, before], [other, now]));
    }
    const press = this.#press;
    if (!press) return;
    const slack = press.touch ? CLICK_SLACK.touch : CLICK_SLACK.mouse;
    press.moved ||= Math.hypot(now.x - press.at.x, now.y - press.at.y) > slack;
    if (press.moved) press.gesture.move(before, now, event);
  };

  #up = (event: PointerEvent): void => {
    this.#places.delete(event.pointerId);
    const press = this.#press;
    this.#release();
    if (press && !press.moved && !press.silent) this.#click(press, event);
  };

  /** The end of a gesture, also because a second finger came: two fingers are another gesture. */
  #release(): void {
    if (this.#press?.moved) this.#press.gesture.end();
    this.#press = null;
  }

  #click({ at, hit, was, takesOut }: Press, event: PointerEvent): void {
    const hands = this.#hands;
    const last = this.#lastClick;
    const near = Math.hypot(at.x - last.at.x, at.y - last.at.y) < DOUBLE.pixels;
    const double = near && event.timeStamp - last.time < DOUBLE.milliseconds && hands.tool() === "move";
    this.#lastClick = { time: double ? -Infinity : event.timeStamp, at };
    if (double) hands.doubleClick(at, hit?.thing ?? null);
    else if (takesOut && hit) hands.toggle(hit.thing);
    else if (!hit) hands.clickBeside(at);
    else if (hands.tool() === "move" && !event.ctrlKey && !event.metaKey)
      hands.select([was.length === 1 && was[0] === hit.thing ? this.#beneath(hit, event) : hit.thing]);
  }

  /** A press on what is chosen alone goes on to what else lies there. */
  #beneath({ thing }: Hit, event: PointerEvent): Thing {
    const hands = this.#hands;
    const { points } = hands.pickable();
    const pixel = (one: Thing) => hands.view().project(points.get(one) ?? [0, 0, 0]);
    const at = pixel(thing);
    const covers = (other: Thing) => Math.hypot(pixel(other).x - at.x, pixel(other).y - at.y) < COVERED;
    const others = this.#hits(event).map((hit) => hit.thing);
    return others.find((other) => other !== thing && covers(other)) ?? thing;
  }

  #wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY;
    this.#hands.setCamera(zoomTo(this.#hands.view(), this.#pixel(event), Math.exp(-pixels * 0.0012)));
  };
}
