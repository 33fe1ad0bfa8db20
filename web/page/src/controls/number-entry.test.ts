import { describe, expect, test } from "vitest";
import { judge, stepOf, stepped } from "./number-entry";

describe("what is typed", () => {
  test("is taken where it is a number within the limits", () => {
    expect(judge("1,5", 0, 2, "m")).toEqual({ value: 1.5, wrong: null });
    expect(judge("0", 0, 2, "m")).toEqual({ value: 0, wrong: null });
  });

  test.each([
    ["abc", "“abc” is not a number."],
    ["NaN", "“NaN” is not a number."],
    [" ", "Nothing is typed."],
    ["x".repeat(500), `“${"x".repeat(19)}…” is not a number.`],
    ["2.1", "From −90 deg to 2 deg."],
    ["-91", "From −90 deg to 2 deg."],
  ])("%j is refused with the reason", (typed, wrong) => {
    expect(judge(typed, -90, 2, "deg")).toEqual({ value: null, wrong });
  });

  test("one-sided limits are said as such", () => {
    expect(judge("-1", 0, Infinity, "").wrong).toBe("At least 0.");
    expect(judge("4", -Infinity, 3, "m").wrong).toBe("At most 3 m.");
  });
});

test("the step follows the size of the value where none is set", () => {
  expect([0, 0.01, 0.0316, 5.7, -120].map((value) => stepOf(value, undefined))).toEqual([
    0.01, 0.001, 0.001, 0.1, 10,
  ]);
  expect(stepOf(5, 0.25)).toBe(0.25);
});

test("steps leave no digits of binary fractions and end at the limits", () => {
  expect(stepped(0.1, 0.2, -1, 1)).toBe(0.3);
  expect(stepped(0.9, 0.2, -1, 1)).toBe(1);
  expect(Object.is(stepped(0.1, -0.1, -1, 1), 0)).toBe(true);
});
