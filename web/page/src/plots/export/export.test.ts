import { describe, expect, test } from "vitest";
import type { Scenario } from "../../scenario";
import type { Palette } from "../../theme/palette";
import { type PlotLine, type PlotSpec, timeAxis } from "../spec";
import { fileName, type Origin } from "./caption";
import { writeCsv } from "./csv";
import { withTexts } from "./png";
import { writeSvg } from "./svg";

const line = (name: string, values: number[], extra: Partial<PlotLine> = {}): PlotLine => ({
  name,
  label: name.toUpperCase(),
  token: name,
  mark: "disc",
  dash: [],
  values: Float64Array.from(values),
  standardErrors: null,
  events: [],
  ...extra,
});
const spec: PlotSpec = {
  name: "orientation",
  title: "Error <of> Q",
  shortTitle: "Q",
  unit: "deg",
  x: timeAxis(Float64Array.of(0.1, 0.2, 0.3)),
  lines: [
    line("kf", [1.25, NaN, 0.1 + 0.2], { events: [2] }),
    line("bound", [1, 1, 1], { mark: null, dash: [7, 4] }),
  ],
  bands: [{ low: 0.4, high: 2, label: "95 %" }],
  threshold: null,
  scale: "log",
  note: null,
};
const origin: Origin = {
  lab: "Track",
  scenario: { name: "größer – Raum", seed: 7 } as Scenario,
  link: "https://example.org/page/#v1.abc",
  trials: null,
};
const palette = { css: (token: string) => (token === "font" ? '"A", serif' : "#123456") } as Palette;

describe("the table", () => {
  const rows = writeCsv(spec, origin).split("\r\n");

  test("begins with where it comes from", () => {
    const comments = rows.filter((row) => row.startsWith("#"));
    expect(comments.join("\n")).toContain("Link: https://example.org/page/#v1.abc");
    expect(comments.join("\n")).toContain("Seed: 7");
    expect(comments.join("\n")).toContain("trial 0");
  });

  test("has units in its head, gaps where there is no number, and every digit", () => {
    const [head, ...numbers] = rows.filter((row) => row && !row.startsWith("#"));
    expect(head).toBe("step,time in s,KF in deg,KF projected,BOUND in deg");
    expect(numbers).toEqual(["1,0.1,1.25,0,1", "2,0.2,,0,1", "3,0.3,0.30000000000000004,1,1"]);
  });

  test("gives averages their standard errors", () => {
    const averaged = {
      ...spec,
      lines: [line("kf", [1, 2, 3], { standardErrors: Float64Array.of(0.1, 0.2, 0.3) })],
    };
    expect(writeCsv(averaged, { ...origin, trials: 200 })).toContain("1,0.1,1,0.1");
    expect(writeCsv(averaged, { ...origin, trials: 200 })).toContain("trials 0 to 199");
  });
});

describe("the drawing", () => {
  const svg = writeSvg(spec, "log", palette, origin);

  test("has title, axes, key and link as text", () => {
    for (const part of ["Error &lt;of&gt; Q in deg", ">time in s<", ">KF<", ">BOUND<", origin.link, "seed 7"])
      expect(svg).toContain(part);
  });

  test("lifts the pen at a gap and dashes what is dashed", () => {
    const paths = [...svg.matchAll(/<path d="([^"]*)" fill="none"/g)].map((match) => match[1]);
    expect(paths[0].match(/M/g)).toHaveLength(2);
    expect(paths[1].match(/M/g)).toHaveLength(1);
    expect(svg).toContain('stroke-dasharray="7 4"');
  });

  test("cuts no mark at an end of the axis", () => {
    const number = (tag: string, name: string) => Number(new RegExp(` ${name}="([^"]*)"`).exec(tag)?.[1]);
    const seen = /<clipPath[^>]*><rect[^>]*>/.exec(svg)?.[0] ?? "";
    const marks = svg.slice(svg.indexOf('<g clip-path="')).match(/<circle[^>]*>/g) ?? [];
    const first = Math.min(...marks.map((mark) => number(mark, "cx") - number(mark, "r")));
    expect(first).toBeGreaterThan(number(seen, "x"));
    // The box of the axes, which a mark at its end is beyond.
    expect(first).toBeLessThan(number(/<rect x=[^>]*fill="none"[^>]*>/.exec(svg)?.[0] ?? "", "x"));
  });

  test("has no number that is none", () => {
    expect(svg).not.toMatch(/NaN|Infinity|undefined/);
  });
});

test("file names say lab, scenario, plot and seed in plain letters", () => {
  expect(fileName(spec, origin, "csv")).toBe("rangelab-track-gro-er-raum-error-of-q-seed-7.csv");
  expect(fileName(spec, { ...origin, trials: 200 }, "png")).toMatch(/-seed-7-200-trials\.png$/);
});

test("texts go behind the header of a PNG with the right check sum", () => {
  // Signature and header of a 1 x 1 picture, then the end.
  const end = [0, 0, 0, 0, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82];
  const header = [
    0, 0, 0, 13, 0x49, 0x48, 0x44, 0x52, 0, 0, 0, 1, 0, 0, 0, 1, 8, 0, 0, 0, 0, 0x3a, 0x7e, 0x9b, 0x55,
  ];
  const png = Uint8Array.from([137, 80, 78, 71, 13, 10, 26, 10, ...header, ...end]);
  const written = withTexts(png, { Source: "x" });
  const view = new DataView(written.buffer);
  expect(view.getUint32(33)).toBe("Source\0x".length);
  expect(new TextDecoder().decode(written.subarray(37, 49))).toBe("tEXtSource\0x");
  expect([...written.subarray(-12)]).toEqual(end);
  // The sum that zlib.crc32 gives for the same bytes.
  expect(view.getUint32(49)).toBe(0xbbf1d2f0);
});
