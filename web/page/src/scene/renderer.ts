import { createWasmScene, type WasmScene } from "../engine";
import { type Backend, offers, startWithin } from "./backends";
import { Canvas2dRenderer } from "./canvas2d";
import type { Color, DrawList } from "./draw-list";
import type { FieldPicture } from "./field";
import { FineField } from "./fine-field";
import type { View } from "./view";
import type { FieldColours } from "../theme/field-colours";

/** A field with the colours of the theme. */
export interface ColouredField {
  readonly picture: FieldPicture;
  readonly colours: FieldColours;
}

/** Draws lists of shapes on one canvas. */
export interface Renderer {
  readonly backend: Backend;
  readonly canvas: HTMLCanvasElement;
  /** Physical pixels. */
  resize(width: number, height: number): void;
  /** The field is under everything else. */
  draw(list: DrawList, view: View, background: Color, field: ColouredField | null): void;
  /** The device is gone: throw this renderer away and start another one on a new canvas. */
  lost(): boolean;
  free(): void;
}

const NOTHING = new Float32Array(0);

/** In the order of the renderer's layout: scale, limit (0: none), opacity, hatch, no bound, count of stops, stops. */
function fieldStyle({ picture, colours }: ColouredField): Float32Array {
  const { low, high, worseThan, opacity } = picture;
  const { hatch, noBound, stops } = colours;
  const limit = worseThan ?? 0;
  return Float32Array.of(low, high, limit, opacity, ...hatch, ...noBound, stops.length, ...stops.flat());
}

class WasmRenderer implements Renderer {
  readonly #scene: WasmScene;
  #width = 1;
  #height = 1;
  /** What the module holds: it is not copied there again. */
  #field: ColouredField | null = null;
  readonly #fine: FineField | null;

  constructor(
    scene: WasmScene,
    readonly backend: Backend,
    readonly canvas: HTMLCanvasElement,
    redraw: () => void,
  ) {
    this.#scene = scene;
    this.#fine = scene.can_compute() ? new FineField(scene, redraw) : null;
  }

  resize(width: number, height: number): void {
    this.#width = width;
    this.#height = height;
    this.#scene.resize(width, height);
  }

  draw(list: DrawList, view: View, background: Color, field: ColouredField | null): void {
    const scene = this.#scene;
    scene.set_view(view.matrix, this.#width, this.#height);
    scene.set_background(background[0], background[1], background[2]);
    this.#setField(field);
    this.#fine?.show(field?.picture.program ?? null);
    scene.set_segments(list.segments);
    scene.set_points(list.points);
    scene.set_ellipsoids(list.ellipsoids);
    scene.set_triangles(list.triangles);
    scene.render();
    this.canvas.toggleAttribute("data-fine-field", this.#fine?.filled ?? false);
  }

  #setField(field: ColouredField | null): void {
    if (field?.picture === this.#field?.picture && field?.colours === this.#field?.colours) return;
    this.#field = field;
    if (!field) return this.#scene.set_field(NOTHING, 0, 0, NOTHING, NOTHING);
    const { values, width, height, corner, u, v } = field.picture;
    const rectangle = Float32Array.of(...corner, ...u, ...v);
    this.#scene.set_field(values, width, height, rectangle, fieldStyle(field));
  }

  lost(): boolean {
    return this.#scene.lost();
  }

  free(): void {
    this.#fine?.stop();
    try {
      this.#scene.free();
    } catch (error) {
      console.warn("A module that stopped could not be cleared away.", error);
    }
  }
}

/** Starts the first of the backends that works, on a canvas of its own; it asks for a picture when it can draw a finer one. */
export async function startRenderer(backends: readonly Backend[], redraw: () => void): Promise<Renderer> {
  for (const backend of backends) {
    if (backend === "canvas2d") continue;
    try {
      if (await offers(backend)) return await startModule(backend, redraw);
    } catch (error) {
      console.warn(`The ${backend} renderer did not start.`, error);
    }
  }
  return new Canvas2dRenderer();
}

async function startModule(backend: "webgpu" | "webgl", redraw: () => void): Promise<Renderer> {
  const canvas = document.createElement("canvas");
  const scene = await startWithin(createWasmScene(backend, canvas), (late) => late.free());
  return new WasmRenderer(scene, backend, canvas, redraw);
}
