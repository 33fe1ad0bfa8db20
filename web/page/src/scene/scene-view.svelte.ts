import type { Session } from "../state/session.svelte";
import type { Timeline } from "../state/timeline.svelte";
import { type Camera, type Direction, DIRECTIONS, limit, zoom } from "./camera";
import { fit, type Inset } from "./fit";
import { bodyPosition, type Frame, frameOf, type Subject } from "./frame";
import { add, length, sub, type Vec3 } from "./geometry";
import { Transition } from "./transition";
import { View, type Viewport } from "./view";

/** How the scene is looked at: size, camera, and the part of space that was fitted. */
export class SceneView {
  viewport: Viewport = $state.raw({ width: 800, height: 500 });
  /** CSS pixels of the view that something else lies over. */
  inset: () => Inset = () => ({ left: 0, top: 0, bottom: 0 });
  frame: Frame = $state.raw()!;
  camera: Camera = $state.raw()!;
  /** The body is followed while it is the subject. */
  subject: Subject = $state("all");
  readonly view = $derived(new View(this.camera, this.viewport));
  readonly #session: Session;
  readonly #timeline: Timeline;
  readonly #transition = new Transition();
  #followed: Vec3 = [0, 0, 0];

  constructor(session: Session, timeline: Timeline) {
    this.#session = session;
    this.#timeline = timeline;
    this.open();
  }

  get planar(): boolean {
    return this.#session.room.dimension === 2;
  }

  /** What a new scene is seen like first. */
  open(): void {
    this.#transition.stop();
    this.camera = limit(this.#fitted("all", this.planar ? DIRECTIONS.plane : DIRECTIONS.space), this.frame);
  }

  /** Goes to where the subject fills the view, seen from a direction or from where one looks now. */
  show(subject: Subject, direction: Direction = this.camera): void {
    this.#go(this.#fitted(subject, direction));
  }

  /** The way a gesture or key asks for, at once. */
  set(camera: Camera): void {
    this.#transition.stop();
    this.camera = limit(camera, this.frame);
  }

  zoom(factor: number): void {
    this.#go(zoom(this.camera, factor));
  }

  /** Brings a point to the middle and goes a little nearer. */
  centre(point: Vec3): void {
    this.#go({ ...this.camera, target: point, distance: Math.min(this.camera.distance, this.frame.radius) });
  }

  /** Moves along with the body; one on the way to it is there at once. */
  follow(): void {
    const at = this.#body();
    const shift = sub(at, this.#followed);
    this.#followed = at;
    if (this.subject !== "body" || length(shift) === 0) return;
    const camera = this.#transition.stop() ?? this.camera;
    this.camera = limit({ ...camera, target: add(camera.target, shift) }, this.frame);
  }

  stop(): void {
    this.#transition.stop();
  }

  #body(): Vec3 {
    return bodyPosition(this.#session.room, this.#session.run, this.#timeline.step);
  }

  #fitted(subject: Subject, direction: Direction): Camera {
    const { room, run } = this.#session;
    this.subject = subject;
    this.frame = frameOf(room, run, subject, this.#timeline.step);
    this.#followed = this.#body();
    return fit(this.frame.points, direction, this.viewport, this.inset());
  }

  #go(camera: Camera): void {
    this.#transition.start(this.camera, limit(camera, this.frame), (next) => (this.camera = next));
  }
}
