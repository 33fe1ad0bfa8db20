import { describe, expect, test } from "vitest";
import { boundRows, compared, toldRows } from "./change";

test.each([
  [0.86, 1, "14 % better"],
  [1.5, 1, "50 % worse"],
  [1.012, 1, "1.2 % worse"],
  [0.9, 1, "10 % better"],
  [1.0001, 1, "the same"],
  [4, 1, "4.00 × worse"],
  [null, 1, "lost"],
  [1, null, "new"],
  [null, null, "none"],
] as const)("%s after %s is %s", (now, before, told) => {
  expect(compared(now, before)).toBe(told);
});

describe("the read-out", () => {
  const now = { angle_sigma: Math.PI / 180, position_sigma: 0.012 };

  test("has degrees and metres", () => {
    expect(boundRows(now, null)).toEqual([
      { name: "orientation", unit: "deg", now: "1.00", change: "" },
      { name: "position", unit: "m", now: "0.0120", change: "" },
    ]);
  });

  test("is told in a sentence", () => {
    const before = { angle_sigma: Math.PI / 90, position_sigma: 0.012 };
    expect(toldRows(boundRows(now, before))).toBe(
      "Orientation bound 1.00 deg, 50 % better; position bound 0.0120 m, the same.",
    );
    const lost = { angle_sigma: null, position_sigma: null };
    expect(toldRows(boundRows(lost, null))).toBe(
      "Orientation bound does not exist; position bound does not exist.",
    );
  });
});
