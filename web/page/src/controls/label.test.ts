import { expect, test } from "vitest";
import { labelParts, plainLabel } from "./label";

test("what follows an underscore stands lower, up to the end of the word", () => {
  expect(labelParts("Turn rate σ_ω of it")).toEqual([
    { text: "Turn rate σ", subscript: false },
    { text: "ω", subscript: true },
    { text: " of it", subscript: false },
  ]);
  expect(labelParts("Seed")).toEqual([{ text: "Seed", subscript: false }]);
});

test("an announcement has no underscores", () => {
  expect(plainLabel("σ_t of t_0")).toBe("σt of t0");
});
