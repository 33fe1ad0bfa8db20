import { FIELD_BLOCK, FieldPainter } from "./field-painter";
import type { ColouredField } from "./renderer";
import type { View } from "./view";

/** Draws a field on a plain canvas: in blocks on a small canvas of its own, which is then stretched over the picture. */
export class FieldCanvas {
  readonly #small = document.createElement("canvas").getContext("2d");
  #field: ColouredField | null = null;
  #painter: FieldPainter | null = null;
  #view: View | null = null;
  /** Where the small canvas lies, CSS pixels; null where the field is not seen. */
  #place: { x: number; y: number } | null = null;

  /** `scale` is physical pixels per CSS pixel. */
  draw(context: CanvasRenderingContext2D, field: ColouredField, view: View, scale: number): void {
    this.#refresh(field, view);
    if (!this.#small || !this.#place) return;
    const { canvas } = this.#small;
    const size = FIELD_BLOCK * scale;
    context.save();
    context.globalAlpha = field.picture.opacity;
    context.drawImage(
      canvas,
      this.#place.x * scale,
      this.#place.y * scale,
      canvas.width * size,
      canvas.height * size,
    );
    context.restore();
  }

  /** What is drawn again as it was keeps its blocks. */
  #refresh(field: ColouredField, view: View): void {
    const same = field.picture === this.#field?.picture && field.colours === this.#field.colours;
    if (same && view === this.#view) return;
    if (!same) this.#painter = new FieldPainter(field);
    [this.#field, this.#view] = [field, view];
    const painted = this.#painter?.paint(view);
    this.#place = painted ? { x: painted.left * FIELD_BLOCK, y: painted.top * FIELD_BLOCK } : null;
    if (!painted || !this.#small) return;
    const { width, height, pixels } = painted;
    const { canvas } = this.#small;
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const bytes = new Uint8ClampedArray(pixels.buffer);
    this.#small.putImageData(new ImageData(bytes, width, height), 0, 0);
  }
}
