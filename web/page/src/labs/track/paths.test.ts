import { beforeAll, describe, expect, test } from "vitest";
import { preset, track, validate } from "../../engine";
import { loadEngineForTests } from "../../engine/testing";
import { pathOptions, speedOf, withPath } from "./paths";

beforeAll(loadEngineForTests);

const quiet = (name: string) => {
  const scenario = preset(name);
  return { ...scenario, motion: { ...scenario.motion, sigma_t: 0, sigma_omega: 0 } };
};

describe.each(["room", "planar", "tracking-paper"])("the paths of %s", (name) => {
  test("are all taken by the engine, and lead where they should", () => {
    const scenario = quiet(name);
    const run = track(scenario);
    for (const { value } of pathOptions(scenario.dimension)) {
      const moving = withPath(scenario, value, run, scenario);
      expect(validate(moving), value).toEqual([]);
      expect(moving.motion.path?.kind ?? "none").toBe(value);
      expect(track(moving).steps).toBe(scenario.steps);
    }
  });

  test("begin as the track was where they are drawn", () => {
    const scenario = quiet(name);
    const run = track(scenario);
    const drawn = track(withPath(scenario, "drawn", run, scenario));
    const extent = Math.max(
      ...run.truth.positions.map((value, index) =>
        Math.abs(value - run.truth.positions[index % scenario.dimension]),
      ),
    );
    const last = scenario.dimension * (run.steps - 1);
    for (let axis = 0; axis < scenario.dimension; axis++)
      expect(Math.abs(drawn.truth.positions[last + axis] - run.truth.positions[last + axis])).toBeLessThan(
        0.02 * extent,
      );
  });

  test("are as fast as is said", () => {
    const scenario = quiet(name);
    for (const kind of ["turn", "figure_eight"] as const) {
      const moving = { ...withPath(scenario, kind, null, null), interval: 1e-3, steps: 2 };
      const { positions } = track(moving).truth;
      const { dimension } = scenario;
      const way = Array.from(
        { length: dimension },
        (_, axis) => positions[dimension + axis] - positions[axis],
      );
      expect(Math.hypot(...way) / 1e-3).toBeCloseTo(speedOf(moving)!, 3);
    }
  });
});

test("back at constant velocity the preset's own comes back", () => {
  const scenario = preset("room");
  const turning = withPath(scenario, "turn", null, scenario);
  expect(turning.motion.velocity).toEqual([0, 0, 0]);
  expect(withPath(turning, "none", null, scenario)).toEqual(scenario);
  expect(speedOf(scenario)).toBeNull();
});
