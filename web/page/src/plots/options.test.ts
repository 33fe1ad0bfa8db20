import { expect, test } from "vitest";
import { emphasisIn, isFaint } from "./options";
import type { PlotLine } from "./spec";

const line = (name: string) => ({ name, mark: "disc" }) as PlotLine;

test("an estimator that a plot does not show makes no other one faint in it", () => {
  const lines = [line("kf"), line("uc-kf")];
  const faint = (wanted: string | null) => lines.map((each) => isFaint(each, emphasisIn({ lines }, wanted)));
  expect(faint("kf")).toEqual([false, true]);
  expect(faint("ouc-ls")).toEqual([false, false]);
  expect(faint(null)).toEqual([false, false]);
});
