import { type Camera, orbit, pan, type View, zoom } from "./camera";
import { startDrag } from "./drag";
import type { Vec3 } from "./geometry";
import { type Hit, pick } from "./picking";

/** What the pointer may look at and change. */
export interface PointerTarget {
  view(): View;
  anchors(): readonly Vec3[];
  selected(): number | null;
  /** Anchors that are drawn anew for every trial cannot be dragged. */
  movable(): boolean;
  dragLimit(): number;
  setCamera(camera: Camera): void;
  hover(index: number | null): void;
  select(index: number | null): void;
  move(index: number, position: Vec3, event: PointerEvent): void;
  drop(): void;
}

interface Place {
  x: number;
  y: number;
}

/** Pixels a pointer may tremble and still be a click. */
const CLICK_SLACK = 4;
const RADIANS_PER_PIXEL = 0.008;

/**
 * One pointer on an anchor drags it (Shift: up and down), elsewhere it turns the scene; Shift, the right or the
 * middle button move the scene, the wheel goes nearer. Two fingers move, turn and stretch.
 */
export class PointerControl {
  readonly #element: HTMLElement;
  readonly #target: PointerTarget;
  readonly #places = new Map<number, Place>();
  #drag: { index: number; follow: (x: number, y: number) => Vec3 } | null = null;
  #pressed: Place | null = null;
  #moved = false;
  #panning = false;

  constructor(element: HTMLElement, target: PointerTarget) {
    this.#element = element;
    this.#target = target;
    element.addEventListener("pointerdown", this.#down);
    element.addEventListener("pointermove", this.#move);
    element.addEventListener("pointerup", this.#up);
    element.addEventListener("pointercancel", this.#up);
    element.addEventListener("pointerleave", () => target.hover(null));
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("wheel", this.#wheel, { passive: false });
  }

  #place(event: PointerEvent | WheelEvent): Place {
    const box = this.#element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  #hit(event: PointerEvent): Hit | null {
    const touch = event.pointerType === "touch";
    return pick(this.#target.view(), this.#target.anchors(), this.#target.selected(), {
      ...this.#place(event),
      touch,
    });
  }

  #down = (event: PointerEvent): void => {
    const place = this.#place(event);
    this.#places.set(event.pointerId, place);
    this.#element.setPointerCapture(event.pointerId);
    if (this.#places.size > 1) return this.#endDrag();
    this.#pressed = place;
    this.#moved = false;
    this.#panning = event.button !== 0;
    const hit = event.button === 0 ? this.#hit(event) : null;
    if (!hit) {
      this.#panning ||= event.shiftKey;
      return;
    }
    this.#target.select(hit.index);
    if (!this.#target.movable()) return;
    const start = this.#target.anchors()[hit.index];
    const mode = hit.kind === "height" || event.shiftKey ? "height" : "plane";
    const follow = startDrag(this.#target.view(), start, place, mode, this.#target.dragLimit());
    this.#drag = { index: hit.index, follow };
  };

  #move = (event: PointerEvent): void => {
    const place = this.#place(event);
    const before = this.#places.get(event.pointerId);
    if (!before) {
      this.#target.hover(this.#hit(event)?.index ?? null);
      return;
    }
    if (this.#places.size === 2) this.#pinch(event.pointerId, before, place);
    else this.#follow(event, before, place);
    this.#places.set(event.pointerId, place);
  };

  #follow(event: PointerEvent, before: Place, place: Place): void {
    const from = this.#pressed ?? before;
    this.#moved ||= Math.hypot(place.x - from.x, place.y - from.y) > CLICK_SLACK;
    if (!this.#moved) return;
    const view = this.#target.view();
    const [dx, dy] = [place.x - before.x, place.y - before.y];
    if (this.#drag) this.#target.move(this.#drag.index, this.#drag.follow(place.x, place.y), event);
    else if (this.#panning) this.#target.setCamera(pan(view.camera, dx, dy, view.viewport));
    else this.#target.setCamera(orbit(view.camera, -dx * RADIANS_PER_PIXEL, dy * RADIANS_PER_PIXEL));
  }

  /** The middle of two fingers moves the scene, their distance stretches it, their angle turns it. */
  #pinch(id: number, before: Place, place: Place): void {
    const other = [...this.#places].find(([key]) => key !== id)?.[1];
    if (!other) return;
    this.#moved = true;
    const view = this.#target.view();
    const [old, now] = [span(other, before), span(other, place)];
    const moved = pan(view.camera, (place.x - before.x) / 2, (place.y - before.y) / 2, view.viewport);
    this.#target.setCamera(orbit(zoom(moved, now.length / old.length), now.angle - old.angle, 0));
  }

  #up = (event: PointerEvent): void => {
    this.#places.delete(event.pointerId);
    if (!this.#moved && !this.#drag && !this.#panning && this.#pressed) this.#target.select(null);
    this.#endDrag();
    if (this.#places.size === 0) this.#pressed = null;
  };

  #endDrag(): void {
    if (this.#drag && this.#moved) this.#target.drop();
    this.#drag = null;
  }

  #wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY;
    this.#target.setCamera(zoom(this.#target.view().camera, Math.exp(-pixels * 0.0012)));
  };
}

function span(a: Place, b: Place): { length: number; angle: number } {
  return { length: Math.max(1, Math.hypot(b.x - a.x, b.y - a.y)), angle: Math.atan2(b.y - a.y, b.x - a.x) };
}
