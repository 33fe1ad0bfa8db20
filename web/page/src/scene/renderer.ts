import { createWasmScene, type WasmScene } from "../engine";
import type { Color, DrawList } from "./draw-list";
import type { View } from "./view";

export const BACKENDS = ["webgpu", "webgl", "canvas2d"] as const;
export type Backend = (typeof BACKENDS)[number];

/** Draws lists of shapes on one canvas. */
export interface Renderer {
  readonly backend: Backend;
  /** Physical pixels. */
  resize(width: number, height: number): void;
  draw(list: DrawList, view: View, background: Color): void;
  /** The device is gone: throw this renderer away and start another one on a new canvas. */
  lost(): boolean;
  free(): void;
}

class WasmRenderer implements Renderer {
  readonly #scene: WasmScene;
  readonly backend: Backend;
  #width = 1;
  #height = 1;

  constructor(scene: WasmScene, backend: Backend) {
    this.#scene = scene;
    this.backend = backend;
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
    this.#scene.free();
  }
}

/** `?renderer=webgl` in the address asks for one; without it all are tried, best first. */
export function wantedBackends(search: string): readonly Backend[] {
  const wanted = new URLSearchParams(search).get("renderer");
  const first = BACKENDS.indexOf(wanted as Backend);
  return first < 0 ? BACKENDS : BACKENDS.slice(first);
}

/** Starts the first of the drawing modules that works, each on a canvas of its own; null where none does. */
export async function startModule(
  backends: readonly Backend[],
): Promise<{ renderer: Renderer; canvas: HTMLCanvasElement } | null> {
  for (const backend of backends) {
    if (backend === "canvas2d" || !(await offers(backend))) continue;
    const canvas = document.createElement("canvas");
    try {
      return { renderer: new WasmRenderer(await createWasmScene(backend, canvas), backend), canvas };
    } catch (error) {
      console.warn(`The ${backend} renderer did not start.`, error);
    }
  }
  return null;
}

/** `navigator.gpu` exists on machines without an adapter, so it is asked for one before a module is loaded. */
async function offers(backend: Backend): Promise<boolean> {
  if (backend === "webgl") return document.createElement("canvas").getContext("webgl2") !== null;
  const gpu = (navigator as { gpu?: { requestAdapter(): Promise<object | null> } }).gpu;
  const adapter = await gpu?.requestAdapter().catch(() => null);
  return adapter !== null && adapter !== undefined;
}
