import { describe, expect, test } from "vitest";
import type { Scenario } from "../../../scenario";
import type { Session } from "../../../state/session.svelte";
import type { ExploreRun } from "../run";
import { BodyDesigner } from "./body-designer.svelte";

/** A session that keeps what it is asked for; its bounds are as good as the body is long. */
function bench(
  sensors: number[][] = [
    [-0.5, 0, 0],
    [0.5, 0, 0],
    [0, 0.5, 0],
  ],
) /* prettier-ignore */ {
  const past: Scenario[] = [];
  let start: Scenario | null = null;
  const session = {
    scenario: { dimension: sensors[0].length, sensors } as Scenario,
    get run() {
      return { exploration: { angle_sigma: 1 / Math.abs(this.scenario.sensors[0][0]), position_sigma: 1 } };
    },
    preview(_: string, next: Scenario) {
      start ??= this.scenario;
      this.scenario = next;
    },
    commit() {
      if (start) past.push(start);
      start = null;
      return true;
    },
    cancel() {
      this.scenario = start ?? this.scenario;
      start = null;
    },
    edit(what: string, next: Scenario) {
      this.preview(what, next);
      return this.commit();
    },
  };
  const designer = new BodyDesigner(session as unknown as Session<ExploreRun, Scenario>);
  return { designer, session, past };
}

describe("a drag", () => {
  test("is one edit, rounded to the grid, and compared with how it began", () => {
    const { designer, past } = bench();
    designer.choose(0);
    designer.take();
    for (const x of [-0.1, -0.3, -0.5021]) designer.move([x, 0, 0]);
    expect(designer.before?.angle_sigma).toBe(2);
    designer.drop();
    expect(past).toHaveLength(1);
    expect(designer.sensors[0]).toEqual([-1, 0, 0]);
    expect(designer.before?.angle_sigma).toBe(2);
  });

  test("holds the picture still until it ends", () => {
    const { designer } = bench();
    const reach = designer.reach;
    designer.choose(1);
    designer.take();
    designer.move([3, 0, 0]);
    expect(designer.reach).toBe(reach);
    designer.drop();
    expect(designer.reach).toBeGreaterThan(3);
  });

  test("taken back leaves no edit", () => {
    const { designer, past } = bench();
    designer.choose(2);
    designer.take();
    designer.move([1, 1, 1]);
    designer.takeBack();
    expect(designer.sensors[2]).toEqual([0, 0.5, 0]);
    expect(past).toHaveLength(0);
  });
});

test("nothing is compared once anything else has changed", () => {
  const { designer, session } = bench();
  designer.change("Sensor added", [...designer.sensors, [0, 0, 1]]);
  expect(designer.before).not.toBeNull();
  session.edit("Anchor moved", { ...session.scenario });
  expect(designer.before).toBeNull();
});

test("a held arrow key is one edit in steps of the grid, with Shift of a tenth", () => {
  const { designer, past } = bench();
  expect(designer.nudge("ArrowRight", false)).toBe(false);
  designer.choose(0);
  designer.look("front");
  for (let i = 0; i < 3; i++) designer.nudge("ArrowRight", false);
  designer.drop();
  expect(designer.sensors[0]).toEqual([-0.47, 0, 0]);
  expect(past).toHaveLength(1);
  designer.nudge("ArrowUp", true);
  designer.drop();
  expect(designer.sensors[0]).toEqual([-0.47, 0, 0.001]);
  expect(past).toHaveLength(2);
});

test("a new sensor is chosen, and after a removal its neighbour", () => {
  const { designer } = bench();
  designer.add();
  expect(designer.chosen).toBe(3);
  designer.remove();
  expect(designer.chosen).toBe(2);
  expect(designer.sensors).toHaveLength(3);
});

test("a planar body is not turned", () => {
  const { designer } = bench([
    [0, 0],
    [1, 0],
  ]);
  const before = designer.direction;
  designer.turn(1, 1);
  expect(designer.direction).toEqual(before);
});
