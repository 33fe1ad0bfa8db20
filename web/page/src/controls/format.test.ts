import { expect, test } from "vitest";
import { formatError, formatNumber, formatPoint, formatReading, parseNumber } from "./format";

test("numbers come back from how they are written", () => {
  for (const value of [0, 1, -2.5, 0.001, 123456, 2 ** 53, 1e-9, -1e12])
    expect(parseNumber(formatNumber(value))).toBe(value);
});

test.each(["", " ", "abc", "1..2", "NaN", "Infinity", "1e999", "0x10", "1,2,3", "--1"])(
  "%j is no number",
  (text) => {
    expect(parseNumber(text)).toBeNull();
  },
);

test("a decimal comma is understood", () => {
  expect(parseNumber(" 1,5 ")).toBe(1.5);
});

test("readings have a dash for what is not there", () => {
  expect([null, NaN, 0.01234, 12.345, 1e-5].map(formatReading)).toEqual([
    "–",
    "–",
    "0.0123",
    "12.3",
    "1.0e−5",
  ]);
});

test("a point is written with all its coordinates", () => {
  expect(formatPoint([0.25, -1, 12.3456789])).toBe("(0.25, −1, 12.3457) m");
});

test("a standard error has two digits", () => {
  expect([0.07093, 11.3, 99.7, 0, NaN].map(formatError)).toEqual(["0.071", "11", "99.7", "0", "–"]);
});
