import { beforeAll, describe, expect, test } from "vitest";
import { topologies } from "../engine";
import { loadEngineForTests } from "../engine/testing";
import { centroid, scaled, sizeOf, topologyOf } from "./topologies";

beforeAll(loadEngineForTests);

describe.each([2, 3])("the bodies of dimension %i", (dimension) => {
  test("are centred and a metre long", () => {
    for (const { name, sensors } of topologies(dimension)) {
      expect(Math.hypot(...centroid(sensors)), name).toBeLessThan(1e-6);
      expect(sizeOf(sensors), name).toBeCloseTo(1, 5);
      expect(
        sensors.every((sensor) => sensor.length === dimension),
        name,
      ).toBe(true);
    }
  });

  test("are known again in any size, and no longer once a sensor is moved", () => {
    for (const { name, sensors } of topologies(dimension)) {
      const small = scaled(sensors, 0.037);
      expect(topologyOf(small)?.name).toBe(name);
      expect(sizeOf(small)).toBeCloseTo(0.037, 6);
      expect(
        topologyOf(
          small.with(
            0,
            small[0].map((value) => value + 0.01),
          ),
        ),
      ).toBeNull();
    }
  });
});

test("sensors at one place have no name and no size", () => {
  expect(
    sizeOf([
      [1, 2],
      [1, 2],
    ]),
  ).toBe(0);
  expect(topologyOf([[1, 2]])).toBeNull();
});
