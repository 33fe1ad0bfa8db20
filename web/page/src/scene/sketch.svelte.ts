import { coordinateStep, roundTo } from "../state/edit";
import type { SceneDocument } from "../family";
import type { Drawing } from "../state/handles";
import type { Session } from "../state/session.svelte";
import type { Vec3 } from "./geometry";

/** The drawing of a new thing over the floor: by a drag, or by a press where it begins and one where it ends. */
export class Sketch {
  /** What is being drawn; null while nothing is. */
  drawing: Drawing | null = $state.raw(null);
  /** Where the first of two presses was. */
  #begin: Vec3 | null = $state.raw(null);
  #end: Vec3 | null = $state.raw(null);
  /** The scenario without the new thing, and the handle by which that is chosen, while it is dragged. */
  #without: SceneDocument | null = null;
  #handle: string | null = null;
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
  }

  /** Corners of what the two presses would make, on the floor. */
  get outline(): readonly Vec3[] {
    const [from, to] = [this.#begin, this.#end ?? this.#begin];
    if (!this.drawing || !from || !to) return [];
    if (this.drawing.outline === "line") return [from, to];
    return [from, [to[0], from[1], from[2]], to, [from[0], to[1], from[2]]];
  }

  start(drawing: Drawing): void {
    this.stop();
    this.drawing = drawing;
    const ends = drawing.outline === "line" ? "its two ends" : "two opposite corners";
    this.#session.announcement = `Draw ${drawing.name}: drag over the floor, or press ${ends}; Escape stops.`;
  }

  stop(): void {
    this.drawing = this.#begin = this.#end = null;
    this.#without = this.#handle = null;
  }

  /** Where the pointer is between the two presses. */
  aim(to: Vec3 | null): void {
    if (this.#begin) this.#end = to;
  }

  /** The second press makes it, up to a height. */
  press(at: Vec3, top: number): void {
    if (this.#begin !== null) {
      this.show(at, at, top);
      this.finish();
      return;
    }
    this.#begin = at;
    this.#session.announcement = "Press where it ends; Escape stops.";
  }

  /** Part of a drag; after a first press it goes on from there. */
  show(from: Vec3, to: Vec3, top: number): void {
    if (!this.drawing) return;
    this.#without ??= this.#session.scenario;
    const room = this.#session.lab.family.room(this.#without);
    const step = coordinateStep(room);
    const rounded = (place: Vec3) => place.slice(0, room.dimension).map((value) => roundTo(value, step));
    const made = this.drawing.make(this.#without, rounded(this.#begin ?? from), rounded([to[0], to[1], top]));
    this.#handle = made.handle;
    this.#session.preview(made.what, made.scenario);
  }

  /** Nothing was drawn where the floor is not seen: one can try again. */
  finish(): void {
    const handle = this.#handle;
    if (handle === null) return this.miss();
    this.stop();
    if (this.#session.commit()) this.#session.selected = [handle];
  }

  miss(): void {
    this.#session.announcement = "The floor is not seen there: look from above.";
  }

  /** Takes a drag back and waits for another one. */
  takeBack(): void {
    if (this.drawing) this.start(this.drawing);
  }
}
