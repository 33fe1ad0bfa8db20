import uPlot from "uplot";
import type { PlotLine, PlotSpec } from "./spec";
import { SHAPES } from "../scene/draw-list";
import { paintMark } from "../scene/mark";
import type { Palette } from "../theme/palette";
import { logRange } from "./range";

/** Marks closer than this hide their line. */
const MARK_SPACING_PIXELS = 22;

/** The look of one plot. `spec` is read anew at every drawing, so new data need no new plot. */
export function plotOptions(
  spec: () => PlotSpec,
  palette: Palette,
  size: { width: number; height: number },
  ondraw: () => void,
): uPlot.Options {
  return {
    ...size,
    legend: { show: false },
    cursor: { drag: { x: false, y: false }, y: false, points: { show: false }, sync: { key: "time" } },
    padding: [8, palette.fontSize, 0, 0],
    scales: { x: { time: false }, y: { distr: 3, range: () => logRange(spec()) } },
    axes: [axis(palette, "time in s"), valueAxis(palette)],
    series: [{}, ...spec().lines.map((line) => series(line, palette))],
    hooks: { draw: [(plot) => drawExtras(plot, spec(), palette), ondraw] },
  };
}

export function plotData(spec: PlotSpec): uPlot.AlignedData {
  const positive = (value: number | null) => (value !== null && value > 0 ? value : null);
  return [
    Array.from(spec.times),
    ...spec.lines.map((line) => line.values.map(positive)),
  ] as uPlot.AlignedData;
}

function axis(palette: Palette, label: string): uPlot.Axis {
  const font = `${0.82 * palette.fontSize}px ${palette.css("font")}`;
  const stroke = palette.css("ink-soft");
  const line = { stroke: palette.css("grid"), width: 1 };
  const named = label ? { label, labelSize: 1.3 * palette.fontSize, labelFont: font, labelGap: 0 } : {};
  return {
    ...named,
    font,
    stroke,
    grid: line,
    ticks: { ...line, size: 4 },
    gap: 4,
    size: 1.7 * palette.fontSize,
  };
}

function valueAxis(palette: Palette): uPlot.Axis {
  const plain = axis(palette, "");
  return {
    ...plain,
    size: 4.2 * palette.fontSize,
    filter: roundSplits,
    values: tickLabels,
    grid: { ...plain.grid, filter: roundSplits },
    ticks: { ...plain.ticks, filter: roundSplits },
  };
}

/** Only 1, 2 and 5 times powers of ten get a line and a number; only powers of ten where there are many. */
function roundSplits(_plot: uPlot, splits: number[]): (number | null)[] {
  const few = Math.log10(splits[splits.length - 1] / splits[0]) < 1.8;
  const wanted = few ? [1, 2, 5] : [1];
  const digit = (value: number) => Math.round(value / 10 ** Math.floor(Math.log10(value) + 1e-9));
  return splits.map((value) => (wanted.includes(digit(value)) ? value : null));
}

function tickLabels(_plot: uPlot, splits: (number | null)[]): (string | null)[] {
  return splits.map((value) => {
    if (value === null) return null;
    return value >= 1e-3 && value < 1e5 ? String(Number(value.toPrecision(1))) : value.toExponential(0);
  });
}

function series(line: PlotLine, palette: Palette): uPlot.Series {
  return {
    label: line.label,
    stroke: palette.css(line.token),
    width: (line.mark ? 1.75 : 2) * palette.weight,
    dash: [...line.dash].map((dash) => dash * palette.weight),
    points: { show: false },
  };
}

function drawExtras(plot: uPlot, spec: PlotSpec, palette: Palette): void {
  const context = plot.ctx;
  context.save();
  context.beginPath();
  context.rect(plot.bbox.left, plot.bbox.top, plot.bbox.width, plot.bbox.height);
  context.clip();
  spec.lines.forEach((line, index) => drawMarks(plot, spec, line, index, palette));
  if (spec.threshold) drawThreshold(plot, spec.threshold, palette);
  context.restore();
}

function drawMarks(plot: uPlot, spec: PlotSpec, line: PlotLine, index: number, palette: Palette): void {
  if (!line.mark) return;
  const ratio = devicePixelRatio;
  const radius = 3.2 * palette.weight * ratio;
  const spacing = MARK_SPACING_PIXELS * palette.weight * ratio;
  const stride = Math.ceil((spacing * spec.times.length) / Math.max(1, plot.bbox.width));
  const color = palette.css(line.token);
  line.values.forEach((value, step) => {
    if (value === null || !(value > 0)) return;
    const at = { x: plot.valToPos(spec.times[step], "x", true), y: plot.valToPos(value, "y", true) };
    // Estimators start their marks at different steps: on shared values they alternate instead of hiding each other.
    if ((step + index) % stride === 0) paintMark(plot.ctx, at, radius, SHAPES[line.mark ?? "disc"], color);
    if (line.events.includes(step)) paintEvent(plot, at.x, spec.times.length, palette, color);
  });
}

/** A tick from the floor of the plot at a step where the estimate was projected; neighbours stay apart. */
function paintEvent(plot: uPlot, x: number, steps: number, palette: Palette, color: string): void {
  const bottom = plot.bbox.top + plot.bbox.height;
  const size = 4 * palette.weight * devicePixelRatio;
  const width = Math.max(1, Math.min(size, (0.6 * plot.bbox.width) / steps));
  plot.ctx.fillStyle = color;
  plot.ctx.fillRect(x - width / 2, bottom - 3 * size, width, 3 * size);
}

function drawThreshold(plot: uPlot, threshold: { value: number; label: string }, palette: Palette): void {
  const context = plot.ctx;
  const y = plot.valToPos(threshold.value, "y", true);
  const right = plot.bbox.left + plot.bbox.width;
  context.strokeStyle = palette.css("et-kf");
  context.lineWidth = 1.75 * palette.weight * devicePixelRatio;
  context.setLineDash([10 * devicePixelRatio, 5 * devicePixelRatio]);
  context.beginPath();
  context.moveTo(plot.bbox.left, y);
  context.lineTo(right, y);
  context.stroke();
  context.fillStyle = palette.css("ink");
  context.font = `600 ${0.9 * palette.fontSize * devicePixelRatio}px ${palette.css("font")}`;
  context.textAlign = "right";
  const below = y - plot.bbox.top < 1.5 * palette.fontSize * devicePixelRatio;
  const shift = below ? 1.1 * palette.fontSize : -5;
  context.fillText(threshold.label, right - 6 * devicePixelRatio, y + shift * devicePixelRatio);
}
