import { saveFile } from "../../state/exports.svelte";
import type { Palette } from "../../theme/palette";
import type { PlotSpec, ScaleKind } from "../spec";
import { describeOrigin, fileName, type Origin } from "./caption";
import { writeCsv } from "./csv";
import { withTexts } from "./png";
import { HEIGHT, WIDTH, writeSvg } from "./svg";

export const FORMATS = ["csv", "png", "svg"] as const;
export type Format = (typeof FORMATS)[number];

/** Pixels of a PNG for each one of the drawing. */
const SHARPNESS = 2;

/** Saves a plot as a file; gives back its name. */
export async function savePlot(
  format: Format,
  spec: PlotSpec,
  scale: ScaleKind,
  palette: Palette,
  origin: Origin,
): Promise<string> {
  const name = fileName(spec, origin, format);
  const content = {
    csv: async () => new Blob([writeCsv(spec, origin)], { type: "text/csv" }),
    svg: async () => new Blob([writeSvg(spec, scale, palette, origin)], { type: "image/svg+xml" }),
    png: async () => {
      const texts = { Software: "rangelab", Source: origin.link, Description: ascii(describeOrigin(origin)) };
      return paint(writeSvg(spec, scale, palette, origin), WIDTH, HEIGHT, texts);
    },
  };
  saveFile(name, await content[format]());
  return name;
}

/** An SVG drawing as pixels, with ASCII texts in the file that say where it comes from. */
export async function paint(
  svg: string,
  width: number,
  height: number,
  texts: Record<string, string>,
): Promise<Blob> {
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = new OffscreenCanvas(SHARPNESS * width, SHARPNESS * height);
    const context = canvas.getContext("2d");
    if (!context) throw new Error("The browser gives no canvas to paint the picture on.");
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    const pixels = await canvas.convertToBlob({ type: "image/png" });
    const bytes = withTexts(new Uint8Array(await pixels.arrayBuffer()), texts);
    return new Blob([bytes], { type: "image/png" });
  } finally {
    URL.revokeObjectURL(address);
  }
}

export function ascii(text: string): string {
  return text
    .replace(/[“”]/g, '"')
    .replaceAll("±", "+-")
    .replace(/[^ -~]/g, "?");
}
