import { Canvas2dRenderer } from "./canvas2d";
import type { Color, DrawList } from "./draw-list";
import type { View } from "./view";
import { type Backend, type Renderer, startModule, wantedBackends } from "./renderer";

interface Act {
  readonly renderer: Renderer;
  readonly canvas: HTMLCanvasElement;
}

/**
 * The renderer on its canvas inside an element. A plain canvas draws until the module for the graphics device has
 * loaded, stays where there is none, and stands in again while a lost device is replaced.
 */
export class Stage {
  readonly #host: HTMLElement;
  readonly #onReady: (backend: Backend) => void;
  #act: Act;
  #width = 1;
  #height = 1;
  #freed = false;

  constructor(host: HTMLElement, onReady: (backend: Backend) => void) {
    this.#host = host;
    this.#onReady = onReady;
    this.#act = this.#standIn();
    void this.#start();
  }

  resize(width: number, height: number): void {
    this.#width = Math.max(1, width);
    this.#height = Math.max(1, height);
    this.#act.renderer.resize(this.#width, this.#height);
  }

  draw(list: DrawList, view: View, background: Color): void {
    if (this.#act.renderer.lost()) {
      this.#use(this.#standIn());
      void this.#start();
    }
    const { renderer, canvas } = this.#act;
    renderer.draw(list, view, background);
    // A new canvas is shown once it has its first picture.
    if (canvas.parentElement !== this.#host) this.#host.replaceChildren(canvas);
  }

  free(): void {
    this.#freed = true;
    this.#act.renderer.free();
  }

  async #start(): Promise<void> {
    const act = await startModule(wantedBackends(location.search));
    if (this.#freed) return act?.renderer.free();
    if (act) this.#use(act);
    this.#onReady(this.#act.renderer.backend);
  }

  #use(act: Act): void {
    this.#act.renderer.free();
    this.#act = act;
    act.renderer.resize(this.#width, this.#height);
  }

  #standIn(): Act {
    const canvas = document.createElement("canvas");
    return { renderer: new Canvas2dRenderer(canvas), canvas };
  }
}
