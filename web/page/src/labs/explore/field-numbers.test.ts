import { beforeAll, expect, test } from "vitest";
import { explore, fieldLayout, fieldProbe, fieldRows, preset } from "../../engine";
import { loadEngineForTests } from "../../engine/testing";
import { UNBOUNDED } from "../../scene/field";
import type { Scenario } from "../../scenario";

beforeAll(loadEngineForTests);

/** What lies between single precision and the bounds' own. */
const SINGLE = 1e-6;

function centreOf(scenario: Scenario, resolution: number, i: number, j: number): number[] {
  const { corner, u, v, width, height } = fieldLayout(scenario, resolution);
  const at = corner.map(
    (value, axis) => value + ((i + 0.5) / width) * u[axis] + ((j + 0.5) / height) * v[axis],
  );
  return at.slice(0, scenario.dimension);
}

test.each(["room", "planar", "corridor"])(
  "cells of the field of %s are the bounds at their centres",
  (name) => {
    const plain = preset(name);
    for (const quantity of ["position", "orientation"] as const) {
      const scenario = { ...plain, field: { ...plain.field, quantity } };
      const { width, height } = fieldLayout(scenario, 24);
      const row = Math.floor(height / 3);
      const values = fieldRows(scenario, 24, row, 1);
      expect(values).toHaveLength(width);
      values.forEach((value, i) => {
        const probe = fieldProbe(scenario, centreOf(scenario, 24, i, row));
        const bound = quantity === "position" ? probe.position_sigma : probe.angle_sigma;
        if (bound === null) expect(value).toBeGreaterThanOrEqual(UNBOUNDED);
        else expect(Math.abs(value / bound - 1), `${quantity} in cell ${i}`).toBeLessThan(SINGLE);
      });
    }
  },
);

test("at the body's own place the probe tells what the exploration tells", () => {
  const scenario = preset("room");
  const { position_sigma, angle_sigma, position_covariance } = explore(scenario);
  expect(fieldProbe(scenario, scenario.start.position)).toMatchObject({
    position_sigma,
    angle_sigma,
    position_covariance,
  });
});

test("a wall hides the anchors behind it", () => {
  const room = preset("room");
  const [x, y] = room.start.position;
  const wall = {
    kind: "wall" as const,
    from: [x + 0.5, y - 9],
    to: [x + 0.5, y + 9],
    bottom: null,
    top: null,
  };
  const walled = { ...room, availability: { ...room.availability, obstacles: [wall] } };
  const behind = room.anchors.map((anchor) => anchor[0] > x + 0.5);
  expect(behind).toContain(true);
  explore(walled).available.forEach((row, anchor) => expect(row.includes(false)).toBe(behind[anchor]));
});
