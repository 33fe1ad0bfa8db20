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
    png: async () => paint(writeSvg(spec, scale, palette, origin), origin),
  };
  saveFile(name, await content[format]());
  return name;
}

/** The SVG drawing as pixels, with the scenario's link among the texts of the file. */
async function paint(svg: string, origin: Origin): Promise<Blob> {
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = new OffscreenCanvas(SHARPNESS * WIDTH, SHARPNESS * HEIGHT);
    const context = canvas.getContext("2d");
    if (!context) throw new Error("The browser gives no canvas to paint the picture on.");
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    const pixels = await canvas.convertToBlob({ type: "image/png" });
    const texts = { Software: "rangelab", Source: origin.link, Description: ascii(describeOrigin(origin)) };
    const bytes = withTexts(new Uint8Array(await pixels.arrayBuffer()), texts);
    return new Blob([bytes], { type: "image/png" });
  } finally {
    URL.revokeObjectURL(address);
  }
}

function ascii(text: string): string {
  return text.replace(/[“”]/g, '"').replace(/[^ -~]/g, "?");
}
