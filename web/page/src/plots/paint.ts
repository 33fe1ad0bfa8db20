import type uPlot from "uplot";
import { SHAPES } from "../scene/draw-list";
import { paintMark } from "../scene/mark";
import { isFaint, type Look } from "./options";
import { type PlotLine, SPREAD, type Threshold } from "./spec";
import { drawnSteps, stepsPerBucket, thin } from "./thin";

/** Marks closer than this hide their line. */
const MARK_SPACING_PIXELS = 22;
const MARK_SIZE = 3.2;
/** Where every value has its own, many lie close together. */
const POINT_SIZE = 2;

/** What lies below the curves: where values are expected, and how sure averages are. */
export function paintGround(plot: uPlot, look: Look): void {
  clipped(plot, 0, () => {
    for (const band of look.spec.bands) paintBand(plot, look, band);
    for (const line of look.spec.lines)
      if (line.standardErrors && !isFaint(line, look.emphasis)) paintSpread(plot, look, line);
  });
}

/** What lies above them: marks, events, the threshold. */
export function paintExtras(plot: uPlot, look: Look): void {
  // A mark at an end of the axis is seen whole.
  clipped(plot, 2 * MARK_SIZE * look.palette.weight * devicePixelRatio, () => {
    look.spec.lines.forEach((line, index) => {
      if (!isFaint(line, look.emphasis)) paintMarks(plot, look, line, index);
      paintEvents(plot, look, line);
    });
    if (look.spec.threshold) paintThreshold(plot, look, look.spec.threshold);
  });
}

/** Paints what lies in the plot, and so many canvas pixels to its left and right. */
function clipped({ ctx, bbox }: uPlot, beside: number, paint: () => void): void {
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left - beside, bbox.top, bbox.width + 2 * beside, bbox.height);
  ctx.clip();
  paint();
  ctx.restore();
}

/** Canvas pixels of a value; what a logarithmic axis cannot hold lies below its end. */
function heightOf(plot: uPlot, { scale, range }: Look, value: number): number {
  return plot.valToPos(scale === "log" ? Math.max(value, 1e-3 * range[0]) : value, "y", true);
}

function paintBand(plot: uPlot, look: Look, band: { low: number; high: number }): void {
  const { ctx, bbox } = plot;
  const [top, bottom] = [heightOf(plot, look, band.high), heightOf(plot, look, band.low)];
  ctx.fillStyle = look.palette.css("bound");
  ctx.globalAlpha = 0.12;
  ctx.fillRect(bbox.left, top, bbox.width, bottom - top);
  ctx.globalAlpha = 0.5;
  for (const edge of [top, bottom]) ctx.fillRect(bbox.left, edge, bbox.width, devicePixelRatio);
  ctx.globalAlpha = 1;
}

function paintSpread(plot: uPlot, look: Look, line: PlotLine): void {
  const { values, standardErrors } = line;
  if (!standardErrors) return;
  const { ctx } = plot;
  const size = stepsPerBucket(values.length);
  const x = drawnSteps(values.length, size).map((step) => plot.valToPos(look.spec.x.values[step], "x", true));
  const edge = (sign: number) =>
    thin(
      values.map((value, k) => value + sign * SPREAD * standardErrors[k]),
      size,
    );
  const [upper, lower] = [edge(1), edge(-1)];
  const present = x.map((_, k) => k).filter((k) => upper[k] !== null && lower[k] !== null);
  ctx.beginPath();
  for (const k of present) ctx.lineTo(x[k], heightOf(plot, look, upper[k] ?? 0));
  for (const k of present.reverse()) ctx.lineTo(x[k], heightOf(plot, look, lower[k] ?? 0));
  ctx.closePath();
  ctx.globalAlpha = 0.2;
  ctx.fillStyle = look.palette.css(line.token);
  ctx.fill();
  ctx.globalAlpha = 1;
}

function paintMarks(plot: uPlot, { palette }: Look, line: PlotLine, index: number): void {
  if (!line.mark) return;
  const ratio = devicePixelRatio;
  const [across, values] = [plot.data[0], plot.data[index + 1]];
  const spacing = MARK_SPACING_PIXELS * palette.weight * ratio;
  const stride = line.points ? 1 : Math.ceil((spacing * across.length) / Math.max(1, plot.bbox.width));
  const size = (line.points ? POINT_SIZE : MARK_SIZE) * palette.weight * ratio;
  // Estimators start their marks at different points: on shared values they alternate instead of hiding each other.
  for (let k = stride - 1 - (index % stride); k < across.length; k += stride) {
    const value = values[k];
    if (value === null || value === undefined) continue;
    const at = { x: plot.valToPos(across[k], "x", true), y: plot.valToPos(value, "y", true) };
    paintMark(plot.ctx, at, size, SHAPES[line.mark], palette.css(line.token));
  }
}

/** A tick from the floor of the plot at every event; neighbours stay apart. */
function paintEvents(plot: uPlot, { spec, palette }: Look, line: PlotLine): void {
  const { ctx, bbox } = plot;
  const size = 4 * palette.weight * devicePixelRatio;
  const width = Math.max(1, Math.min(size, (0.6 * bbox.width) / spec.x.values.length));
  ctx.fillStyle = palette.css(line.token);
  for (const step of line.events) {
    const x = plot.valToPos(spec.x.values[step], "x", true);
    ctx.fillRect(x - width / 2, bbox.top + bbox.height - 3 * size, width, 3 * size);
  }
}

function paintThreshold(plot: uPlot, look: Look, { heights, token }: Threshold): void {
  const { ctx } = plot;
  ctx.strokeStyle = look.palette.css(token);
  ctx.lineWidth = 1.75 * look.palette.weight * devicePixelRatio;
  ctx.setLineDash([10 * devicePixelRatio, 5 * devicePixelRatio]);
  ctx.beginPath();
  const steps = drawnSteps(heights.length, stepsPerBucket(heights.length));
  for (const step of steps)
    ctx.lineTo(plot.valToPos(look.spec.x.values[step], "x", true), heightOf(plot, look, heights[step]));
  ctx.stroke();
}
