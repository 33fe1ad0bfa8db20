import type { View } from "./camera";
import type { Color, DrawList } from "./draw-list";
import { type Backend, type Renderer, startRenderer, wantedBackends } from "./renderer";

/** The renderer on its canvas inside an element: starts it, follows the size, starts it anew when the device is lost. */
export class Stage {
  #renderer: Renderer | null = null;
  #starting = false;
  #width = 0;
  #height = 0;
  readonly #host: HTMLElement;
  readonly #onReady: (backend: Backend) => void;

  constructor(host: HTMLElement, onReady: (backend: Backend) => void) {
    this.#host = host;
    this.#onReady = onReady;
    void this.#start();
  }

  resize(width: number, height: number): void {
    if (width === this.#width && height === this.#height) return;
    this.#width = width;
    this.#height = height;
    this.#renderer?.resize(width, height);
  }

  draw(list: DrawList, view: View, background: Color): void {
    if (this.#renderer?.lost()) void this.#start();
    else this.#renderer?.draw(list, view, background);
  }

  free(): void {
    this.#renderer?.free();
    this.#renderer = null;
  }

  async #start(): Promise<void> {
    if (this.#starting) return;
    this.#starting = true;
    this.free();
    const renderer = await startRenderer(() => this.#newCanvas(), wantedBackends(location.search));
    renderer.resize(Math.max(1, this.#width), Math.max(1, this.#height));
    this.#renderer = renderer;
    this.#starting = false;
    this.#onReady(renderer.backend);
  }

  #newCanvas(): HTMLCanvasElement {
    const canvas = document.createElement("canvas");
    canvas.setAttribute("aria-hidden", "true");
    this.#host.replaceChildren(canvas);
    return canvas;
  }
}
