import * as actions from "../state/scene-actions";
import type { Drawing } from "../state/handles";
import { handlesOf, middleOf, movable, placeOf, type Places, type Thing } from "../state/things";
import type { Workspace } from "../state/workspace.svelte";
import type { Camera } from "./camera";
import { destination } from "./drag";
import { bodyPosition } from "./frame";
import { length, lift, sub, type Vec3 } from "./geometry";
import type { SceneHands, Tool } from "./gestures";
import { gridOf } from "./grid";
import { thingPoints } from "./handles";
import { inside, lifterShows, type Pickable } from "./picking";
import type { SceneView } from "./scene-view.svelte";
import { Sketch } from "./sketch.svelte";
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
  readonly #sketch: Sketch;
  readonly #workspace: Workspace;
  readonly #look: SceneView;
  /** Where what is dragged was when the drag began. */
  #from: Places | null = null;

  constructor(workspace: Workspace, look: SceneView) {
    this.#workspace = workspace;
    this.#look = look;
    this.#sketch = new Sketch(workspace.session);
  }

  get #session() {
    return this.#workspace.session;
  }

  tool = (): Tool => {
    if (this.drawing()) return "draw";
    return this.#tool === "destination" && this.selected().length === 0 ? "move" : this.#tool;
  };

  setTool(tool: Tool): void {
    this.#sketch.stop();
    this.#tool = tool;
    if (tool === "destination")
      this.#session.announcement = "Press where it shall go; Escape keeps it where it is.";
  }

  /** What is being drawn; nothing of another lab. */
  drawing = (): Drawing | null => {
    const { drawing } = this.#sketch;
    return drawing && this.#workspace.lab.drawings?.includes(drawing) ? drawing : null;
  };

  startDrawing(drawing: Drawing): void {
    this.setTool("move");
    this.#workspace.hovered = null;
    this.select([]);
    this.#sketch.start(drawing);
  }

  outline = (): readonly Vec3[] => (this.drawing() ? this.#sketch.outline : []);

  view = () => this.#look.view;
  planar = () => this.#look.planar;
  #points(): ReadonlyMap<Thing, Vec3> {
    const { room, run } = this.#session;
    return thingPoints({ room, run, handles: handlesOf(this.#session), frame: this.#look.frame });
  }

  pickable = (): Pickable => ({
    points: this.#points(),
    last: this.selected().at(-1),
    lifted: this.lifted(),
  });
  selected = () => this.#session.selected;
  movable = (thing: Thing) => movable(this.#session, thing);
  lifts = (thing: Thing) => !this.planar() && placeOf(this.#session, thing).length === 3;

  /** Where what was chosen last is, while the triangle that lifts it shows. */
  lifted(): Vec3 | null {
    const last = this.selected().at(-1);
    if (last === undefined || !this.lifts(last) || !lifterShows(this.view())) return null;
    return this.#points().get(last) ?? null;
  }

  dragLimit = () => 20 * this.#look.frame.radius;
  gridSpacing = () => gridOf(this.view(), this.#look.frame, []).spacing;
  setCamera(camera: Camera): void {
    this.#workspace.ray = null;
    this.#look.set(camera);
  }

  select = (things: readonly Thing[]) => actions.select(this.#session, things);
  toggle = (thing: Thing) => actions.toggle(this.#session, thing);
  frameThings = (corners: readonly [Pixel, Pixel] | null) => (this.rectangle = corners);
  selectInside = ([from, to]: readonly [Pixel, Pixel]) =>
    this.select(inside(this.view(), this.pickable().points, from, to));

  hover(thing: Thing | null, pixel: Pixel): void {
    this.#workspace.hovered = thing;
    this.#workspace.ray = this.#workspace.lab.field ? this.view().ray(pixel) : null;
    this.#pointer = pixel;
    this.#sketch.aim(this.#floorUnder(pixel, false));
  }

  leave(): void {
    this.#workspace.hovered = null;
    this.#workspace.ray = null;
    this.#pointer = null;
  }

  move(shift: Vec3, event: PointerEvent): void {
    this.awaiting = event;
    this.#workspace.ray = null;
    this.#from ??= actions.movablePlaces(this.#session);
    actions.shiftBy(this.#session, this.#from, shift);
  }

  draw(from: Pixel, to: Pixel, snaps: boolean): void {
    this.#workspace.ray = null;
    const [begin, end] = [this.#floorUnder(from, snaps), this.#floorUnder(to, snaps)];
    if (begin && end) this.#sketch.show(begin, end, this.#top());
  }

  drop(): void {
    this.#from = null;
    if (this.drawing()) this.#sketch.finish();
    else this.#session.commit();
  }

  takeBack(): void {
    this.#from = null;
    this.#session.cancel();
    this.#sketch.takeBack();
  }

  clickBeside(pixel: Pixel): void {
    if (this.drawing()) this.#pressFloor(pixel);
    else if (this.tool() === "destination") this.sendTo(pixel);
    else if (this.tool() === "move") this.select([]);
  }

  #pressFloor(pixel: Pixel): void {
    const floor = this.#floorUnder(pixel, false);
    if (floor) this.#sketch.press(floor, this.#top());
    else this.#sketch.miss();
  }

  doubleClick(pixel: Pixel, thing: Thing | null): void {
    const point = thing === null ? this.#bodyUnder(pixel) : this.pickable().points.get(thing);
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
    if (!movable(this.#session, 0)) return;
    actions.add(this.#session, (pixel && this.#floorUnder(pixel, false)) ?? undefined);
  }

  /** The middle of what is chosen, or of the body where nothing is. */
  middle(): Vec3 {
    const { points } = this.pickable();
    const chosen = this.selected().map((thing) => points.get(thing) ?? [0, 0, 0]);
    return chosen.length === 0 ? this.#body() : lift(middleOf(chosen));
  }

  /** The place on the floor under a pixel; null where it would be far outside of the scene. */
  #floorUnder(pixel: Pixel, snaps: boolean): Vec3 | null {
    const point = this.view().onLevel(pixel, this.#look.frame.ground);
    if (!point || !this.#near(point)) return null;
    const spacing = this.gridSpacing();
    const snapped = (value: number) => (snaps ? Math.round(value / spacing) * spacing : value);
    return [snapped(point[0]), snapped(point[1]), point[2]];
  }

  /** The top of the room: as high as the highest anchor, where that is above the floor. */
  #top(): number {
    const { ground, whole } = this.#look.frame;
    const highest = Math.max(...this.#session.room.anchors.map((anchor) => lift(anchor)[2]));
    return highest > ground ? highest : whole[1][2];
  }

  #near(point: Vec3): boolean {
    const { centre, radius } = this.#look.frame;
    return length(sub(point, centre)) < FARTHEST * radius;
  }

  #body(): Vec3 {
    return bodyPosition(this.#session.room, this.#session.run, this.#workspace.timeline.step);
  }

  #bodyUnder(pixel: Pixel): Vec3 | null {
    const body = this.#body();
    const { x, y, depth } = this.view().project(body);
    return depth > 0 && Math.hypot(x - pixel.x, y - pixel.y) < BODY_REACH ? body : null;
  }
}
