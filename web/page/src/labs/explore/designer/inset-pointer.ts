import type { Pixel, View } from "../../../scene/view";
import type { BodyDesigner } from "./body-designer.svelte";
import { shiftOf } from "./body-view";

/** Less is a trembling hand, not a drag. */
const SLACK_PIXELS = 3;
const RADIANS_PER_PIXEL = 0.01;

interface Press {
  readonly pointer: number;
  readonly sensor: number | null;
  readonly from: Pixel;
  /** The view as it was when the pointer went down. */
  readonly view: View;
  last: Pixel;
  moved: boolean;
}

/** What a pointer does in the inset: it drags a sensor, turns the body beside them, or sends the chosen sensor. */
export class InsetPointer {
  #press: Press | null = null;

  constructor(
    private readonly designer: BodyDesigner,
    private readonly view: () => View,
  ) {}

  /** `sensor` is the one under the pointer. */
  down(pointer: number, pixel: Pixel, sensor: number | null): void {
    if (this.#press) return;
    const { designer } = this;
    if (designer.placing && designer.chosen !== null) return this.#place(pixel, designer.chosen);
    if (sensor !== null) designer.choose(sensor);
    this.#press = { pointer, sensor, from: pixel, view: this.view(), last: pixel, moved: false };
  }

  move(pointer: number, pixel: Pixel): void {
    const press = this.#press;
    if (press?.pointer !== pointer) return;
    const { designer } = this;
    if (!press.moved) {
      if (Math.hypot(pixel.x - press.from.x, pixel.y - press.from.y) < SLACK_PIXELS) return;
      press.moved = true;
      if (press.sensor !== null) designer.take();
    }
    if (press.sensor !== null) designer.move(shiftOf(press.view, press.from, inside(press.view, pixel)));
    else
      designer.turn(
        (press.last.x - pixel.x) * RADIANS_PER_PIXEL,
        (pixel.y - press.last.y) * RADIANS_PER_PIXEL,
      );
    press.last = pixel;
  }

  up(pointer: number): void {
    const press = this.#end(pointer);
    if (!press) return;
    if (press.moved) this.designer.drop();
    else if (press.sensor === null) this.designer.choose(null);
  }

  cancel(pointer: number): void {
    if (this.#end(pointer)) this.designer.takeBack();
  }

  #end(pointer: number): Press | null {
    const press = this.#press;
    if (press?.pointer !== pointer) return null;
    this.#press = null;
    return press;
  }

  #place(pixel: Pixel, sensor: number): void {
    const { designer } = this;
    const view = this.view();
    const [x, y, z = 0] = designer.sensors[sensor];
    designer.take();
    designer.move(shiftOf(view, view.project([x, y, z]), pixel));
    designer.drop();
    designer.placing = false;
  }
}

/** A sensor does not leave the picture. */
function inside({ viewport }: View, { x, y }: Pixel): Pixel {
  const within = (value: number, end: number) => Math.min(end, Math.max(0, value));
  return { x: within(x, viewport.width), y: within(y, viewport.height) };
}
