import { beforeAll, describe, expect, test } from "vitest";
import { advise, bestNext, fieldLayout, fieldRows, nextAt, preset } from "../../engine";
import { loadEngineForTests } from "../../engine/testing";
import type { Scenario } from "../../scenario";
import { UNBOUNDED } from "../../scene/field";
import { freshEnds, pictureOf, unitOf } from "./fields";
import { endsOf } from "./scale";
import { fieldTitle, gain, inAngles, shownOf, withNextAnchor, withShown } from "./next-anchor";

beforeAll(loadEngineForTests);

const room = () => withShown(preset("room"), "next_anchor");
const withTarget = (scenario: Scenario, target: Scenario["placement"]["target"]): Scenario => ({
  ...scenario,
  placement: { ...scenario.placement, target },
});

test("a field shows a bound of the body, or one more anchor, and remembers which bound", () => {
  const turned = withShown(preset("room"), "orientation");
  expect(turned.field).toMatchObject({ subject: "body", quantity: "orientation" });
  const next = withShown(turned, "next_anchor");
  expect(next.field).toMatchObject({ subject: "next_anchor", quantity: "orientation" });
  expect([shownOf(turned.field), shownOf(next.field)]).toEqual(["orientation", "next_anchor"]);
});

test("the unit of one more anchor is that of what the placement is for", () => {
  const units = (["position", "orientation", "pose"] as const).map((target) => {
    const scenario = withTarget(room(), target);
    return [unitOf(scenario).unit, inAngles(scenario), fieldTitle(scenario)];
  });
  expect(units).toEqual([
    ["m", false, "Bound of the position, one more anchor here"],
    ["deg", true, "Bound of the orientation, one more anchor here"],
    ["m", false, "Bound of the pose, one more anchor here"],
  ]);
});

describe("one more anchor", () => {
  test("is worth at each cell what the adviser says once it is there", () => {
    const scenario = room();
    const { width, height, corner, u, v } = fieldLayout(scenario, 12);
    const row = Math.floor(height / 2);
    const values = fieldRows(scenario, 12, row, 1);
    values.forEach((value, i) => {
      const point = corner.map((c, k) => c + ((i + 0.5) / width) * u[k] + ((row + 0.5) / height) * v[k]);
      const place = nextAt(scenario, point);
      const added = advise(withNextAnchor(scenario, place)).value!;
      expect(Math.abs(place.after! / added - 1)).toBeLessThan(1e-9);
      expect(Math.abs(value / added - 1)).toBeLessThan(1e-6);
      expect(added).toBeLessThan(place.before!);
    });
  });

  test("has a best place", () => {
    const best = bestNext(room())!;
    expect(best.after).toBeLessThan(best.before!);
    expect(gain(best)).toMatch(/^7\.14 mm now, [0-6]\.\d+ mm with one more anchor here$/);
  });

  test("has no value inside a keep-out box, and the reason is told", () => {
    const scenario = room();
    scenario.placement.keep_out = [{ low: [1, 1, 0], high: [2, 2, 3] }];
    const place = nextAt(scenario, [1.5, 1.5, 1]);
    expect([place.after, place.cause]).toEqual([null, "no anchor may stand inside keep-out zone 1"]);
    expect(fieldRows(scenario, 16, 4, 2).some((value) => value >= UNBOUNDED)).toBe(true);
  });
});

test("a graphics device is not asked for it, and the scale is as wide as the numbers", () => {
  const scenario = room();
  const layout = fieldLayout(scenario, 16);
  const values = fieldRows(scenario, 16, 0, layout.height);
  const picture = pictureOf(
    { ...layout, scenario, resolution: 16, values },
    scenario,
    freshEnds(scenario)(values),
    1,
  );
  expect(picture.program).toBeNull();
  expect(picture.low).toBeLessThanOrEqual(Math.min(...values));
  expect(picture.high / picture.low).toBeLessThan(1.2);
  const { low, high } = endsOf(Float32Array.of(0.006123, ...Array(40).fill(0.006987), 1e30), 1);
  expect([low.toPrecision(6), high.toPrecision(6)]).toEqual(["0.00612000", "0.00699000"]);
  expect(endsOf(Float32Array.of(1e30), 1).high).toBeGreaterThan(0);
});
