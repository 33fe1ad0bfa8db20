import { describe, expect, test } from "vitest";
import { rigidBody } from "../../rigid-body/family";
import type { Scenario } from "../../scenario";
import { putAt, type Thing } from "../../state/things";
import { drawings } from "./drawings";
import { handles } from "./handles";

const lab = { family: rigidBody, handles };
const wall = { kind: "wall" as const, from: [1, 0], to: [1, 4], bottom: null, top: 2 };

function scene(change: Partial<Scenario> = {}): Scenario {
  return {
    dimension: 3,
    anchors: [
      [0, 0, 0],
      [5, 5, 3],
    ],
    start: { position: [1, 1, 1], orientation: [] },
    redraw_anchors: null,
    availability: { max_ranges: [], obstacles: [wall] },
    placement: { limits: null, region: null, fixed: [], keep_out: [{ low: [1, 1, 0], high: [2, 3, 2] }] },
    ...change,
  } as unknown as Scenario;
}

const put = (places: [Thing, number[]][], scenario = scene()) =>
  putAt({ scenario, lab }, new Map<Thing, number[]>(places));
const keepOut = (scenario: Scenario) => scenario.placement.keep_out[0];
const named = (scenario: Scenario) => new Map(handles(scenario).map((handle) => [handle.name, handle]));

describe("handles", () => {
  test("boxes have corners and a middle, walls ends and a middle without a height", () => {
    expect(handles(scene()).map(({ name, place }) => [name, place])).toEqual([
      ["Keep out 1, middle", [1.5, 2, 0]],
      ["Keep out 1, low corner", [1, 1, 0]],
      ["Keep out 1, high corner", [2, 3, 2]],
      ["Wall 1, middle", [1, 2]],
      ["Wall 1, end A", [1, 0]],
      ["Wall 1, end B", [1, 4]],
    ]);
  });

  test("every one goes to where it is put, and nothing else of the scenario changes", () => {
    const scenario = scene();
    const before = JSON.stringify(scenario);
    for (const { id, place } of handles(scenario)) {
      const goal = place.map((value, axis) => value + 0.25 * (axis + 1));
      const next = handles(put([[id, goal]], scenario));
      expect(next.find((handle) => handle.id === id)?.place).toEqual(goal);
      const whole = id.split(" ")[0];
      for (const other of handles(scenario).filter((handle) => !handle.id.startsWith(whole)))
        expect(next.find((handle) => handle.id === other.id)?.place).toEqual(other.place);
    }
    expect(JSON.stringify(scenario)).toBe(before);
  });

  test("a corner stops one step before the opposite one, axis by axis", () => {
    expect(keepOut(put([["keep-out-0 low corner", [9, 2, 1]]]))).toEqual({
      low: [1.99, 2, 1],
      high: [2, 3, 2],
    });
    expect(keepOut(put([["keep-out-0 high corner", [0, 9, -1]]]))).toEqual({
      low: [1, 1, 0],
      high: [1.01, 9, 0.01],
    });
  });

  test.each([
    [["low corner", "high corner"]],
    [["high corner", "low corner"]],
    [["high corner", "low corner", "middle"]],
  ])("%s moved together keep the size of the box, however far they go", (chosen) => {
    const places = new Map(handles(scene()).map(({ id, place }) => [id, place]));
    for (const far of [7, -7]) {
      const moved = chosen.map((which): [Thing, number[]] => {
        const id = `keep-out-0 ${which}`;
        return [id, places.get(id)!.map((value) => value + far)];
      });
      expect(keepOut(put(moved))).toEqual({
        low: [1 + far, 1 + far, far],
        high: [2 + far, 3 + far, 2 + far],
      });
    }
  });

  test("the middle takes the whole along, to the last digit", () => {
    const box = { low: [0.1, 0.2, 0.3], high: [0.7, 0.4, 0.9] };
    const scenario = scene({ placement: { ...scene().placement, keep_out: [box] } });
    expect(keepOut(put([["keep-out-0 middle", [1.4, 0.3, 0.3]]], scenario))).toEqual({
      low: [1.1, 0.2, 0.3],
      high: [1.7, 0.4, 0.9],
    });
    expect(put([["obstacle-0 middle", [3, 2.5]]]).availability.obstacles).toEqual([
      { ...wall, from: [3, 0.5], to: [3, 4.5] },
    ]);
  });

  test("what a handle belongs to is removed as a whole", () => {
    const whole = named(scene()).get("Wall 1, end B")?.whole;
    expect(whole?.name).toBe("Wall 1");
    expect(whole?.without(scene()).availability.obstacles).toEqual([]);
  });
});

describe("drawings", () => {
  const draw = (name: string, from: number[], to: number[], scenario = scene()) =>
    drawings.find((drawing) => drawing.name === name)!.make(scenario, from, to);

  test("a box lies between its corners in whatever order, up to the top, and is chosen by its middle", () => {
    const { scenario, what, handle } = draw("a keep-out box", [4, 1, 0], [3, 2, 2.5]);
    expect(scenario.placement.keep_out[1]).toEqual({ low: [3, 1, 0], high: [4, 2, 2.5] });
    expect(what).toBe("Keep out 2 drawn from (3, 1, 0) m to (4, 2, 2.5) m");
    expect(handles(scenario).map(({ id }) => id)).toContain(handle);
  });

  test("a wall stands on the floor; in the plane it has no heights", () => {
    const { scenario } = draw("a wall", [0, 1, 0], [3, 2, 2.5]);
    expect(scenario.availability.obstacles[1]).toEqual({
      kind: "wall",
      from: [0, 1],
      to: [3, 2],
      bottom: 0,
      top: 2.5,
    });
    const planar = scene({ dimension: 2, availability: { max_ranges: [], obstacles: [] } });
    expect(draw("a wall", [0, 1], [3, 2], planar).scenario.availability.obstacles[0]).toMatchObject({
      bottom: null,
      top: null,
    });
  });

  test("a box is never empty", () => {
    const { low, high } = draw("where the body may be", [1, 1, 0], [1, 2, 3]).scenario.placement.region!;
    expect([low, high]).toEqual([
      [1, 1, 0],
      [1.01, 2, 3],
    ]);
  });

  test.each(drawings.map(({ name }) => name))("%s: its handle is there", (name) => {
    const { scenario, handle } = draw(name, [0, 0, 0], [1, 2, 3]);
    expect(handles(scenario).map(({ id }) => id)).toContain(handle);
  });
});
