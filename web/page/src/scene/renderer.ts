import { createWasmScene, type WasmScene } from "../engine";
import { type Backend, offers, startWithin } from "./backends";
import { Canvas2dRenderer } from "./canvas2d";
import type { Color, DrawList } from "./draw-list";
import type { View } from "./view";

/** Draws lists of shapes on one canvas. */
export interface Renderer {
  readonly backend: Backend;
  readonly canvas: HTMLCanvasElement;
  /** Physical pixels. */
  resize(width: number, height: number): void;
  draw(list: DrawList, view: View, background: Color): void;
  /** The device is gone: throw this renderer away and start another one on a new canvas. */
  lost(): boolean;
  free(): void;
}

class WasmRenderer implements Renderer {
  readonly #scene: WasmScene;
  #width = 1;
  #height = 1;

  constructor(
    scene: WasmScene,
    readonly backend: Backend,
    readonly canvas: HTMLCanvasElement,
  ) {
    this.#scene = scene;
  }

  resize(width: number, height: number): void {
    this.#width = width;
    this.#height = height;
    this.#scene.resize(width, height);
  }

  draw(list: DrawList, view: View, background: Color): void {
    const scene = this.#scene;
    scene.set_view(view.matrix, this.#width, this.#height);
    scene.set_background(background[0], background[1], background[2]);
    scene.set_segments(list.segments);
    scene.set_points(list.points);
    scene.set_ellipsoids(list.ellipsoids);
    scene.set_triangles(list.triangles);
    scene.render();
  }

  lost(): boolean {
    return this.#scene.lost();
  }

  free(): void {
    try {
      this.#scene.free();
    } catch (error) {
      console.warn("A module that stopped could not be cleared away.", error);
    }
  }
}

/** Starts the first of the backends that works, on a canvas of its own. */
export async function startRenderer(backends: readonly Backend[]): Promise<Renderer> {
  for (const backend of backends) {
    if (backend === "canvas2d") continue;
    try {
      if (await offers(backend)) return await startModule(backend);
    } catch (error) {
      console.warn(`The ${backend} renderer did not start.`, error);
    }
  }
  return new Canvas2dRenderer();
}

async function startModule(backend: "webgpu" | "webgl"): Promise<Renderer> {
  const canvas = document.createElement("canvas");
  const scene = await startWithin(createWasmScene(backend, canvas), (late) => late.free());
  return new WasmRenderer(scene, backend, canvas);
}
