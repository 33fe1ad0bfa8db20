import * as actions from "../state/scene-actions";
import { middleOf, movable, type Places, type Thing } from "../state/things";
import type { Workspace } from "../state/workspace.svelte";
import { thingPoints } from "./anchors";
import type { Camera } from "./camera";
import { destination } from "./drag";
import { bodyPosition } from "./frame";
import { length, lift, sub, type Vec3 } from "./geometry";
import type { SceneHands, Tool } from "./gestures";
import { gridOf } from "./grid";
import { inside } from "./picking";
import type { SceneView } from "./scene-view.svelte";
import type { Pixel } from "./view";

/** CSS pixels around the middle of the body that count as the body. */
const BODY_REACH = 24;
/** A press near the horizon would put an anchor far outside of the scene: this many radii are the farthest. */
const FARTHEST = 3;

/** What pointers and keys do to the scene. */
export class Hands implements SceneHands {
  #tool: Tool = $state("move");
  /** Opposite corners of the rectangle that is being drawn around things. */
  rectangle: readonly [Pixel, Pixel] | null = $state.raw(null);
  /** The pointer event whose effect has not been drawn yet. */
  awaiting: PointerEvent | null = null;
  /** Where the pointer was last, so that a key can mean the place under it. */
  #pointer: Pixel | null = null;
  readonly #workspace: Workspace;
  readonly #look: SceneView;
  /** Where what is dragged was when the drag began. */
  #from: Places | null = null;

  constructor(workspace: Workspace, look: SceneView) {
    this.#workspace = workspace;
    this.#look = look;
  }

  get #session() {
    return this.#workspace.session;
  }

  tool = (): Tool => (this.#tool === "destination" && this.selected().length === 0 ? "move" : this.#tool);

  setTool(tool: Tool): void {
    this.#tool = tool;
    if (tool === "destination")
      this.#session.announcement = "Press where it shall go; Escape keeps it where it is.";
  }

  view = () => this.#look.view;
  planar = () => this.#look.planar;
  points = () => thingPoints(this.#session);
  selected = () => this.#session.selected;
  movable = (thing: Thing) => movable(this.#session.scenario, thing);
  dragLimit = () => 20 * this.#look.frame.radius;
  gridSpacing = () => gridOf(this.view(), this.#look.frame, []).spacing;
  setCamera = (camera: Camera) => this.#look.set(camera);
  select = (things: readonly Thing[]) => actions.select(this.#session, things);
  toggle = (thing: Thing) => actions.toggle(this.#session, thing);
  frameThings = (corners: readonly [Pixel, Pixel] | null) => (this.rectangle = corners);
  selectInside = ([from, to]: readonly [Pixel, Pixel]) =>
    this.select(inside(this.view(), this.points(), from, to));

  hover(thing: Thing | null, pixel: Pixel): void {
    this.#workspace.hovered = thing;
    this.#workspace.ray = this.#workspace.lab.field ? this.view().ray(pixel) : null;
    this.#pointer = pixel;
  }

  leave(): void {
    this.#workspace.hovered = null;
    this.#workspace.ray = null;
    this.#pointer = null;
  }

  move(shift: Vec3, event: PointerEvent): void {
    this.awaiting = event;
    this.#from ??= actions.movablePlaces(this.#session);
    actions.shiftBy(this.#session, this.#from, shift);
  }

  drop(): void {
    this.#from = null;
    this.#session.commit();
  }

  takeBack(): void {
    this.#from = null;
    this.#session.cancel();
  }

  clickBeside(pixel: Pixel): void {
    if (this.tool() === "destination") this.sendTo(pixel);
    else if (this.tool() === "move") this.select([]);
  }

  doubleClick(pixel: Pixel, thing: Thing | null): void {
    const point = thing === null ? this.#bodyUnder(pixel) : this.points().get(thing);
    if (point) this.#look.centre(point);
    else this.addAt(pixel);
  }

  /** Moves what is chosen to the place under a pixel, at its own height. */
  sendTo(pixel: Pixel): void {
    const point = destination(this.view(), this.middle(), pixel);
    if (point && this.#near(point)) actions.moveTo(this.#session, point);
    this.setTool("move");
  }

  /** Adds an anchor on the floor under a pixel, by default under the pointer, else where it helps to be seen. */
  addAt(pixel: Pixel | null = this.#pointer): void {
    const { scenario } = this.#session;
    if (!movable(scenario, 0)) return;
    const ground = pixel && this.view().onLevel(pixel, this.#look.frame.ground);
    actions.add(this.#session, ground && this.#near(ground) ? ground : undefined);
  }

  /** The middle of what is chosen, or of the body where nothing is. */
  middle(): Vec3 {
    const points = this.points();
    const chosen = this.selected().map((thing) => points.get(thing) ?? [0, 0, 0]);
    return chosen.length === 0 ? this.#body() : lift(middleOf(chosen));
  }

  #near(point: Vec3): boolean {
    const { centre, radius } = this.#look.frame;
    return length(sub(point, centre)) < FARTHEST * radius;
  }

  #body(): Vec3 {
    return bodyPosition(this.#session.scenario, this.#session.run, this.#workspace.timeline.step);
  }

  #bodyUnder(pixel: Pixel): Vec3 | null {
    const body = this.#body();
    const { x, y, depth } = this.view().project(body);
    return depth > 0 && Math.hypot(x - pixel.x, y - pixel.y) < BODY_REACH ? body : null;
  }
}
