import { SHAPES } from "../../scene/draw-list";
import { outline } from "../../scene/mark";
import type { Palette } from "../../theme/palette";
import { axisRange } from "../options";
import { Projection } from "../projection";
import { valueRange } from "../range";
import { type PlotLine, type PlotSpec, type ScaleKind, SPREAD, titleWithUnit, withUnit } from "../spec";
import { drawnSteps, stepsPerBucket, thin } from "../thin";
import { tickLabel, ticks } from "../ticks";
import { describeOrigin, type Origin, remarks } from "./caption";

/** Pixels of the picture; a slide or half a page. */
export const WIDTH = 960;
export const HEIGHT = 540;
const AXES = { left: 76, top: 52, width: 640, height: 408 };
const KEY = { x: AXES.left + AXES.width + 28, row: 24 };
const FONT = 15;
const MARK_SPACING = 34;
/** A mark at an end of the axis is seen whole. */
const MARK_REACH = 6;

type Attributes = Record<string, string | number>;

/** A plot as vectors with selectable text: title, axes, lines with their marks, key, and where it comes from. */
export function writeSvg(spec: PlotSpec, scale: ScaleKind, palette: Palette, origin: Origin): string {
  const description = [describeOrigin(origin), ...remarks(spec), origin.link].join("\n");
  const style = { "font-size": 13, fill: palette.css("ink-soft") };
  const caption = element(
    "text",
    { x: AXES.left, y: HEIGHT - 14, ...style },
    escaped(describeOrigin(origin)),
  );
  const body = [
    drawPanel(spec, scale, palette, "axes"),
    element("a", { href: origin.link, target: "_blank" }, caption),
  ];
  return svgFile(palette, WIDTH, HEIGHT, titleWithUnit(spec), description, origin.link, body);
}

/** Title, axes, lines with their marks, and key: WIDTH by HEIGHT, nothing around it. */
export function drawPanel(spec: PlotSpec, scale: ScaleKind, palette: Palette, clip: string): string {
  const picture = new Picture(spec, scale, palette);
  return [
    picture.text(titleWithUnit(spec), AXES.left, 32, { "font-size": 20, "font-weight": 600 }),
    picture.axes(),
    `<clipPath id="${clip}">${element("rect", box(MARK_REACH))}</clipPath>`,
    element("g", { "clip-path": `url(#${clip})` }, picture.contents()),
    element("rect", { ...box(), fill: "none", stroke: palette.css("line") }),
    picture.key(),
  ].join("\n");
}

/** A drawing as a file, with a title, a description and data that are not seen. */
export function svgFile(
  palette: Palette,
  width: number,
  height: number,
  title: string,
  description: string,
  metadata: string,
  body: readonly string[],
): string {
  const all = [
    element("title", {}, escaped(title)),
    element("desc", {}, escaped(description)),
    element("metadata", {}, escaped(metadata)),
    element("rect", { width: "100%", height: "100%", fill: palette.css("surface") }),
    ...body,
  ];
  const root = {
    xmlns: "http://www.w3.org/2000/svg",
    width,
    height,
    viewBox: `0 0 ${width} ${height}`,
    "font-family": palette.css("font").replaceAll('"', "'"),
    "font-size": FONT,
  };
  return `<?xml version="1.0" encoding="UTF-8"?>\n${element("svg", root, all.join("\n"))}\n`;
}

/** The axes, and so many pixels to their left and right. */
function box(beside = 0): Attributes {
  return { x: AXES.left - beside, y: AXES.top, width: AXES.width + 2 * beside, height: AXES.height };
}

class Picture {
  readonly #projection: Projection;
  readonly #steps: number[];
  readonly #bucket: number;

  constructor(
    private readonly spec: PlotSpec,
    private readonly scale: ScaleKind,
    private readonly palette: Palette,
  ) {
    this.#projection = new Projection(
      AXES,
      1,
      axisRange(spec.x),
      spec.x.scale,
      valueRange(spec, scale),
      scale,
    );
    this.#bucket = stepsPerBucket(spec.x.values.length);
    this.#steps = drawnSteps(spec.x.values.length, this.#bucket);
  }

  text(content: string, x: number, y: number, attributes: Attributes = {}): string {
    return element("text", { x, y, fill: this.palette.css("ink"), ...attributes }, escaped(content));
  }

  axes(): string {
    const { across, values, bottom, left, right, top } = this.#projection;
    const grid = { stroke: this.palette.css("grid") };
    const soft = { fill: this.palette.css("ink-soft") };
    const along = ticks(across, this.spec.x.scale, 8).map((value) => {
      const x = round(this.#projection.x(value));
      const label = this.text(tickLabel(value), x, bottom + 20, { ...soft, "text-anchor": "middle" });
      return element("line", { x1: x, x2: x, y1: top, y2: bottom, ...grid }) + label;
    });
    const up = ticks(values, this.scale, 9).map((value) => {
      const y = round(this.#projection.y(value));
      const label = this.text(tickLabel(value), left - 8, y + 5, { ...soft, "text-anchor": "end" });
      return element("line", { x1: left, x2: right, y1: y, y2: y, ...grid }) + label;
    });
    const name = this.text(withUnit(this.spec.x.name, this.spec.x.unit), (left + right) / 2, bottom + 42, {
      ...soft,
      "text-anchor": "middle",
    });
    return [...along, ...up, name].join("\n");
  }

  contents(): string {
    const { bands, lines, threshold } = this.spec;
    const parts = [
      ...bands.map((band) => this.#band(band.low, band.high)),
      ...lines.map((line) => this.#spread(line)),
      ...lines.map((line, index) => this.#line(line, index)),
      ...lines.map((line) => this.#events(line)),
      this.#now(),
    ];
    if (threshold) {
      const stroke = this.palette.css(threshold.token);
      const d = this.#path(this.#steps.map((step) => threshold.heights[step]));
      parts.push(element("path", { d, fill: "none", stroke, "stroke-width": 2, "stroke-dasharray": "10 5" }));
    }
    return parts.join("\n");
  }

  key(): string {
    const { lines, threshold } = this.spec;
    const rows = lines.map((line, row) => {
      const y = AXES.top + 10 + row * KEY.row;
      const stroke = this.palette.css(line.token);
      const sample = {
        x1: KEY.x,
        x2: KEY.x + 32,
        y1: y,
        y2: y,
        stroke,
        "stroke-width": 2,
        ...dashes(line.dash),
      };
      return [
        element("line", sample),
        this.#mark(line, KEY.x + 16, y),
        this.text(line.label, KEY.x + 42, y + 5),
      ].join("");
    });
    if (threshold) {
      const y = AXES.top + 10 + lines.length * KEY.row;
      const stroke = this.palette.css(threshold.token);
      const sample = { x1: KEY.x, x2: KEY.x + 32, y1: y, y2: y, stroke, "stroke-width": 2 };
      rows.push(element("line", { ...sample, "stroke-dasharray": "10 5" }));
      rows.push(this.text(threshold.label, KEY.x + 42, y + 5));
    }
    return rows.join("\n");
  }

  #y(value: number): number {
    const lowest = 1e-3 * this.#projection.values[0];
    return round(this.#projection.y(this.scale === "log" ? Math.max(value, lowest) : value));
  }

  #x(point: number): number {
    return round(this.#projection.x(this.spec.x.values[this.#steps[point]]));
  }

  /** Through the points there are; a gap lifts the pen. */
  #path(values: readonly (number | null)[]): string {
    let pen = "M";
    let d = "";
    values.forEach((value, point) => {
      if (value === null || Number.isNaN(value) || (this.scale === "log" && value <= 0)) pen = "M";
      else {
        d += `${pen}${this.#x(point)} ${this.#y(value)}`;
        pen = "L";
      }
    });
    return d;
  }

  #band(low: number, high: number): string {
    const [top, bottom] = [this.#y(high), this.#y(low)];
    const fill = this.palette.css("bound");
    const area = { ...box(), y: top, height: round(bottom - top) };
    return element("rect", { ...area, fill, "fill-opacity": 0.12, stroke: fill, "stroke-opacity": 0.5 });
  }

  #spread({ values, standardErrors, token }: PlotLine): string {
    if (!standardErrors) return "";
    const edge = (sign: number) =>
      thin(
        values.map((value, step) => value + sign * SPREAD * standardErrors[step]),
        this.#bucket,
      );
    const corners = (list: (number | null)[]) =>
      list.flatMap((value, point) => (value === null ? [] : [`${this.#x(point)},${this.#y(value)}`]));
    const points = [...corners(edge(1)), ...corners(edge(-1)).reverse()].join(" ");
    return element("polygon", { points, fill: this.palette.css(token), "fill-opacity": 0.2 });
  }

  #line(line: PlotLine, index: number): string {
    const values = thin(line.values, this.#bucket);
    const stroke = this.palette.css(line.token);
    const d = this.#path(values);
    const style = { fill: "none", stroke, "stroke-width": 2, ...dashes(line.dash) };
    const path = line.points ? "" : element("path", { d, ...style });
    const stride = line.points ? 1 : Math.ceil((MARK_SPACING * values.length) / AXES.width);
    const marks = values.flatMap((value, point) =>
      value === null || (this.scale === "log" && value <= 0) || (point + index) % stride !== 0
        ? []
        : [this.#mark(line, this.#x(point), this.#y(value))],
    );
    return element("g", {}, element("title", {}, escaped(line.label)) + path + marks.join(""));
  }

  #mark({ mark, token }: PlotLine, x: number, y: number): string {
    const color = this.palette.css(token);
    const open = { fill: "none", stroke: color, "stroke-width": 1.8 };
    if (mark === "disc") return element("circle", { cx: x, cy: y, r: 4, fill: color });
    if (mark === "ring") return element("circle", { cx: x, cy: y, r: 4, ...open });
    if (mark === "cross") return element("path", { d: `M${x - 3.5} ${y - 3.5}l7 7m0 -7l-7 7`, ...open });
    if (mark === null) return "";
    const corners = outline(SHAPES[mark]).map(([dx, dy]) => `${round(x + 4.4 * dx)},${round(y + 4.4 * dy)}`);
    return element("polygon", { points: corners.join(" "), fill: color });
  }

  /** Where the scenario lies. */
  #now(): string {
    const { now } = this.spec.x;
    if (now === null) return "";
    const { top, bottom } = this.#projection;
    const x = round(this.#projection.clampedX(now));
    return element("line", {
      x1: x,
      x2: x,
      y1: top,
      y2: bottom,
      stroke: this.palette.css("accent"),
      "stroke-width": 2,
    });
  }

  #events({ events, token }: PlotLine): string {
    const { bottom } = this.#projection;
    const width = Math.min(4, (0.6 * AXES.width) / this.spec.x.values.length);
    const d = events
      .map((step) => `M${round(this.#projection.x(this.spec.x.values[step]))} ${bottom}v-14`)
      .join("");
    const stroke = this.palette.css(token);
    return d ? element("path", { d, stroke, "stroke-width": round(width) }) : "";
  }
}

export function element(name: string, attributes: Attributes, content = ""): string {
  const list = Object.entries(attributes).map(([key, value]) => ` ${key}="${escaped(String(value))}"`);
  return content ? `<${name}${list.join("")}>${content}</${name}>` : `<${name}${list.join("")}/>`;
}

function dashes(dash: readonly number[]): Attributes {
  return dash.length > 0 ? { "stroke-dasharray": dash.join(" ") } : {};
}

export function escaped(text: string): string {
  return text
    .replaceAll("&", "&amp;")
    .replaceAll("<", "&lt;")
    .replaceAll(">", "&gt;")
    .replaceAll('"', "&quot;");
}

function round(value: number): number {
  return Math.round(value * 100) / 100;
}
