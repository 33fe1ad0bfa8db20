import { expect, test } from "vitest";
import type { SceneDocument } from "../family";
import { sourceOf } from "./spec";

const scene = (seed: number): SceneDocument => ({ version: 1, name: "a", seed, view: null });

test("a plot says of which scenario it is: of the one at hand, unless its averages are still those of an earlier one", () => {
  const [begun, now] = [scene(1), scene(2)];
  const picture = { scenario: begun, averages: { trials: 50 } };
  expect(sourceOf(picture, false, now)).toEqual({ scenario: now, trials: 50 });
  expect(sourceOf(picture, true, now)).toEqual({ scenario: begun, trials: 50 });
  expect(sourceOf(null, true, now)).toEqual({ scenario: now, trials: null });
});
