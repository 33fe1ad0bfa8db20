/** A finished figure as a file: like those of the command line, with the command and the scenarios inside. */
import type { FigurePicture, FigureReport } from "../figure";
import { ascii, paint } from "../plots/export/files";
import { drawPanel, element, escaped, HEIGHT, svgFile, WIDTH } from "../plots/export/svg";
import type { PlotSpec, ScaleKind } from "../plots/spec";
import { saveFile } from "../state/exports.svelte";
import type { Palette } from "../theme/palette";
import { foundWords, targetWords, VERDICTS } from "./claims";

export const FIGURE_FORMATS = ["svg", "png", "csv", "json"] as const;
export type FigureFormat = (typeof FIGURE_FORMATS)[number];

/** How the panels look on the page. */
export interface FigureLook {
  readonly specs: readonly PlotSpec[];
  scaleOf(spec: PlotSpec): ScaleKind;
  readonly palette: Palette;
}

/** The labels of estimated covariances need more room than those of the labs. */
const FIGURE_WIDTH = WIDTH + 80;
const EDGE = 40;
const ROW = 22;
/** Letters of a line as wide as a panel. */
const LETTERS = 118;

/** Saves it; gives back the name of the file: "tracking-2-1000-trials-seed-1.svg". */
export async function saveFigure(
  format: FigureFormat,
  picture: FigurePicture,
  csv: string,
  look: FigureLook,
): Promise<string> {
  const { name, trials, seed } = picture.report;
  const file = `${name}-${trials}-trials-seed-${seed}.${format}`;
  saveFile(file, await contentOf(format, picture, csv, look));
  return file;
}

async function contentOf(
  format: FigureFormat,
  { report, json }: FigurePicture,
  csv: string,
  look: FigureLook,
): Promise<Blob> {
  if (format === "json") return new Blob([json], { type: "application/json" });
  if (format === "csv") return new Blob([csv], { type: "text/csv" });
  const { svg, height } = figureSvg(report, look);
  if (format === "svg") return new Blob([svg], { type: "image/svg+xml" });
  return paint(svg, FIGURE_WIDTH, height, {
    Software: "rangelab",
    Title: ascii(headingOf(report)),
    Description: ascii(report.caption),
    Command: report.command,
    Scenarios: ascii(JSON.stringify(report.scenarios)),
  });
}

export function headingOf({ paper, title }: Pick<FigureReport, "paper" | "title">): string {
  return `${paper}: ${title}`;
}

/** The panels below each other, then what is claimed and found. */
export function figureSvg(report: FigureReport, look: FigureLook): { svg: string; height: number } {
  const { palette, specs } = look;
  const metadata = JSON.stringify({ command: report.command, scenarios: report.scenarios });
  const top = 3 * ROW;
  const panels = specs.map((spec, index) => {
    const drawing = drawPanel(spec, look.scaleOf(spec), palette, `axes-${index}`);
    return element("g", { transform: `translate(0 ${top + index * HEIGHT})` }, drawing);
  });
  const lines = [...wrapped(report.caption), "", ...claimLines(report)];
  const below = top + specs.length * HEIGHT;
  const height = below + lines.length * ROW + EDGE;
  const text = (content: string, y: number, style = {}) =>
    element("text", { x: EDGE, y, fill: palette.css("ink"), ...style }, escaped(content));
  const body = [
    text(headingOf(report), 1.4 * ROW, { "font-weight": 600 }),
    text(`${report.trials} trials; bands of two standard errors. ${report.command}`, 2.4 * ROW, {
      fill: palette.css("ink-soft"),
      "font-size": 13,
    }),
    ...panels,
    ...lines.map((line, index) => (line ? text(line, below + (index + 1) * ROW) : "")),
  ];
  const title = headingOf(report);
  return { svg: svgFile(palette, FIGURE_WIDTH, height, title, report.caption, metadata, body), height };
}

function claimLines({ claims }: FigureReport): string[] {
  return claims.flatMap((claim) => {
    const { what, target, verdict } = claim;
    const { symbol, words } = VERDICTS[verdict];
    return wrapped(`${symbol} ${what}: ${foundWords(claim)} (${targetWords(target)}): ${words}`);
  });
}

function wrapped(text: string): string[] {
  const lines = [""];
  for (const word of text.split(" ")) {
    const line = lines[lines.length - 1];
    if (line && line.length + word.length >= LETTERS) lines.push(word);
    else lines[lines.length - 1] = line ? `${line} ${word}` : word;
  }
  return lines;
}
