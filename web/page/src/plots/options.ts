import uPlot from "uplot";
import type { Palette } from "../theme/palette";
import { paintExtras, paintGround } from "./paint";
import type { Range } from "./range";
import type { PlotAxis, PlotLine, PlotSpec, ScaleKind } from "./spec";
import { drawnSteps, stepsPerBucket, thin } from "./thin";
import { tickLabel, ticks } from "./ticks";

/** All that decides how a plot looks; read anew at every drawing, so new data need no new plot. */
export interface Look {
  readonly spec: PlotSpec;
  readonly palette: Palette;
  readonly scale: ScaleKind;
  /** The ends of the value axis. */
  readonly range: Range;
  /** The one estimator that stands out, or null. */
  readonly emphasis: string | null;
}

/** How faint an estimator is drawn while another one stands out. */
const FAINT = 0.18;

export function plotOptions(
  look: () => Look,
  size: { width: number; height: number },
  ondraw: (plot: uPlot) => void,
): uPlot.Options {
  const { palette, spec, scale } = look();
  return {
    ...size,
    legend: { show: false },
    cursor: { show: false },
    // Where the axis is not time its last number stands at its very end.
    padding: [0.6 * palette.fontSize, (spec.x.timed ? 1 : 1.8) * palette.fontSize, 0, 0],
    scales: {
      x: { time: false, distr: distribution(spec.x.scale), range: () => axisRange(look().spec.x) },
      y: { distr: distribution(scale), range: () => [...look().range] },
    },
    axes: [acrossAxis(look), valueAxis(look)],
    series: [{}, ...spec.lines.map((line) => series(line, palette))],
    hooks: {
      drawAxes: [(plot) => paintGround(plot, look())],
      draw: [(plot) => paintExtras(plot, look()), ondraw],
    },
  };
}

/** uPlot's numbers for the kinds of scales. */
function distribution(scale: ScaleKind): 1 | 3 {
  return scale === "log" ? 3 : 1;
}

export function axisRange({ values }: PlotAxis): [number, number] {
  const [first, last] = [values[0], values[values.length - 1]];
  return last > first ? [first, last] : [first - 1, first + 1];
}

export function plotData({ x, lines }: PlotSpec, scale: ScaleKind): uPlot.AlignedData {
  const size = stepsPerBucket(x.values.length);
  const shown = (value: number | null) => (scale === "log" && value !== null && value <= 0 ? null : value);
  return [
    drawnSteps(x.values.length, size).map((step) => x.values[step]),
    ...lines.map((line) => thin(line.values, size).map(shown)),
  ];
}

/** The estimator that stands out in a plot; none where no line of it is that one's. */
export function emphasisIn({ lines }: Pick<PlotSpec, "lines">, wanted: string | null): string | null {
  return lines.some((line) => line.name === wanted) ? wanted : null;
}

/** Dims every estimator but the one that stands out; bounds are the ruler and stay. */
export function applyEmphasis(plot: uPlot, { spec, emphasis }: Look): void {
  spec.lines.forEach((line, index) => (plot.series[index + 1].alpha = isFaint(line, emphasis) ? FAINT : 1));
}

export function isFaint(line: PlotLine, emphasis: string | null): boolean {
  return emphasis !== null && line.mark !== null && line.name !== emphasis;
}

/** Along time the unit at every number says enough; anything else has its name below, which costs a row. */
function acrossAxis(look: () => Look): uPlot.Axis {
  const { palette } = look();
  const most = (plot: uPlot) => plot.width / (4.5 * palette.fontSize);
  return {
    ...axis(palette),
    size: 1.7 * palette.fontSize,
    splits: (plot, _axis, low, high) => ticks([low, high], look().spec.x.scale, most(plot)),
    filter: (_plot, splits) => splits,
    values: (_plot, splits) => {
      const { timed, unit } = look().spec.x;
      return splits.map((value) => (timed ? `${tickLabel(value)} ${unit}` : tickLabel(value)));
    },
  };
}

function valueAxis(look: () => Look): uPlot.Axis {
  const { palette } = look();
  const most = (plot: uPlot) => Math.max(3, plot.height / (2.4 * palette.fontSize));
  return {
    ...axis(palette),
    size: 3.7 * palette.fontSize,
    splits: (plot) => ticks(look().range, look().scale, most(plot)),
    filter: (_plot, splits) => splits,
    values: (_plot, splits) => splits.map(tickLabel),
  };
}

function axis(palette: Palette): uPlot.Axis {
  const line = { stroke: palette.css("grid"), width: 1, filter: (_plot: uPlot, splits: number[]) => splits };
  return {
    font: `${0.82 * palette.fontSize}px ${palette.css("font")}`,
    stroke: palette.css("ink-soft"),
    grid: line,
    ticks: { ...line, size: 4 },
    gap: 4,
  };
}

function series(line: PlotLine, palette: Palette): uPlot.Series {
  return {
    label: line.label,
    stroke: palette.css(line.token),
    width: (line.points ? 0 : line.mark ? 1.75 : 2) * palette.weight,
    dash: line.dash.map((dash) => dash * palette.weight),
    points: { show: false },
  };
}
