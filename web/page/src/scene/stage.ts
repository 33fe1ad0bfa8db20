import { type Backend, wantedBackends } from "./backends";
import { Canvas2dRenderer } from "./canvas2d";
import type { Color, DrawList } from "./draw-list";
import { type ColouredField, type Renderer, startRenderer } from "./renderer";
import type { View } from "./view";

/** Milliseconds between looks whether the device is still there: it may go while nothing is drawn. */
const WATCH = 500;
/** A device that is lost as often as this is not asked for again. */
const MOST_LOSSES = 3;

/**
 * The renderer on its canvas inside an element. A plain canvas draws until the module for the graphics device has
 * loaded, stays where there is none, and stands in again while a lost device is replaced.
 */
export class Stage {
  readonly #host: HTMLElement;
  readonly #onChange: (backend: Backend | "") => void;
  readonly #redraw: () => void;
  readonly #watch: number;
  #renderer: Renderer = new Canvas2dRenderer();
  #width = 1;
  #height = 1;
  #losses = 0;
  #freed = false;

  /** `onChange` hears of each renderer, so that it gets its first picture; empty while one is being started.
   *  `redraw` is called when the renderer can draw the last picture finer. */
  constructor(host: HTMLElement, onChange: (backend: Backend | "") => void, redraw: () => void) {
    this.#host = host;
    this.#onChange = onChange;
    this.#redraw = redraw;
    this.#watch = window.setInterval(() => this.#renderer.lost() && this.#replace(), WATCH);
    void this.#start();
  }

  resize(width: number, height: number): void {
    this.#width = Math.max(1, width);
    this.#height = Math.max(1, height);
    this.#attempt(() => this.#renderer.resize(this.#width, this.#height));
  }

  draw(list: DrawList, view: View, background: Color, field: ColouredField | null): void {
    if (this.#renderer.lost()) this.#replace();
    this.#attempt(() => this.#renderer.draw(list, view, background, field));
    // A new canvas is shown once it has its first picture.
    const { canvas } = this.#renderer;
    if (canvas.parentElement !== this.#host) this.#host.replaceChildren(canvas);
  }

  free(): void {
    this.#freed = true;
    window.clearInterval(this.#watch);
    this.#renderer.free();
  }

  /** A device that refuses is as good as lost. */
  #attempt(action: () => void): void {
    try {
      action();
    } catch (error) {
      console.warn(`The ${this.#renderer.backend} renderer failed.`, error);
      this.#replace();
      action();
    }
  }

  /** Lets the plain canvas stand in and asks for a new device. */
  #replace(): void {
    this.#losses += 1;
    this.#use(new Canvas2dRenderer());
    this.#onChange("");
    void this.#start();
  }

  async #start(): Promise<void> {
    const backends = wantedBackends(location.search);
    const renderer = await startRenderer(this.#losses < MOST_LOSSES ? backends : ["canvas2d"], this.#redraw);
    if (this.#freed) return renderer.free();
    this.#use(renderer);
    this.#onChange(renderer.backend);
  }

  #use(renderer: Renderer): void {
    this.#renderer.free();
    this.#renderer = renderer;
    this.resize(this.#width, this.#height);
  }
}
