import type { WasmScene } from "../engine";
import type { FieldProgram } from "./field";

/** The part of a scene on a graphics device that computes fields. */
export type ComputingScene = Pick<
  WasmScene,
  "set_field_kernel" | "compute_field" | "drop_fine_field" | "lost"
>;

/** A device that needs more milliseconds for a field would hold up a drag. */
export const FAST = 50;
/** Milliseconds without a new picture after which such a device computes. */
export const REST = 250;

/**
 * Has the graphics device compute the field that is shown, one computation at a time. Devices that are slow, or not yet
 * known to be fast, do it only while the scene is at rest; after a failure the coarse grid is all there is.
 */
export class FineField {
  readonly #scene: ComputingScene;
  readonly #onFilled: () => void;
  #wanted: FieldProgram | null = null;
  /** What the scene's fine grid was last filled by. */
  #submitted: FieldProgram | null = null;
  #kernel: string | null = null;
  #fast = false;
  #working = false;
  #stopped = false;
  #rest: ReturnType<typeof setTimeout> | undefined;

  /** `onFilled` hears when there is another picture to draw. */
  constructor(scene: ComputingScene, onFilled: () => void) {
    this.#scene = scene;
    this.#onFilled = onFilled;
  }

  /** Whether the scene holds the whole fine grid of what is shown. */
  get filled(): boolean {
    return this.#submitted !== null && !this.#working;
  }

  /** To be told at each picture, after the scene has got the coarse grid: each one puts off a slow device. */
  show(program: FieldProgram | null): void {
    if (this.#stopped) return;
    if (program !== this.#wanted) {
      this.#wanted = program;
      if (this.#submitted) this.#scene.drop_fine_field();
      this.#submitted = null;
    }
    clearTimeout(this.#rest);
    if (program === null || program === this.#submitted || this.#working) return;
    if (this.#fast) void this.#fill(program);
    else this.#rest = setTimeout(() => void this.#fill(program), REST);
  }

  /** The scene is not touched any more. */
  stop(): void {
    this.#stopped = true;
    this.#submitted = null;
    clearTimeout(this.#rest);
  }

  async #fill(program: FieldProgram): Promise<void> {
    this.#working = true;
    try {
      // Without a new text the computation is submitted at once, so that the picture under way already has it.
      if (program.text !== this.#kernel) await this.#compile(program.text);
      if (program === this.#wanted && !this.#stopped) await this.#compute(program);
    } catch (error) {
      return this.#fail(error);
    } finally {
      this.#working = false;
    }
    if (this.#stopped) return;
    this.show(this.#wanted);
    if (this.filled) this.#onFilled();
  }

  async #compile(text: string): Promise<void> {
    await this.#scene.set_field_kernel(text);
    this.#kernel = text;
  }

  async #compute(program: FieldProgram): Promise<void> {
    const { parameters, width, height } = program;
    const start = performance.now();
    this.#submitted = program;
    await this.#scene.compute_field(parameters, width, height);
    this.#fast = performance.now() - start <= FAST;
  }

  /** The owner replaces a scene whose device is lost: there is nothing to tell. */
  #fail(error: unknown): void {
    if (this.#stopped) return;
    this.stop();
    if (!this.#scene.lost())
      console.warn("The field stays coarse: the graphics device did not compute it.", error);
  }
}
