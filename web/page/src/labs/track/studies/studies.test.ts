import { beforeAll, describe, expect, test } from "vitest";
import { drawsBlock, budgetBlock, preset, quantiles, track } from "../../../engine";
import { loadEngineForTests } from "../../../engine/testing";
import type { StudySubject } from "../../../state/study.svelte";
import type { Averages } from "../../../state/study.svelte";
import type { BudgetBlock } from "../../../workers/messages";
import { budget } from "./budget";
import { draws } from "./draws";

beforeAll(loadEngineForTests);

const PAPER = 0.15;

function averages<A extends Averages>(
  subject: StudySubject<A>,
  run: (first: number) => Float64Array,
  blocks: number,
): A {
  const sum = subject.openSum();
  for (let index = 0; index < blocks; index++) sum.push(run(20 * index));
  try {
    return sum.read();
  } finally {
    sum.free();
  }
}

describe("the budget of the threshold", () => {
  const scenario = () => preset("tracking-paper");
  const pictureOf = () => {
    const subject = budget.subject(scenario(), track(scenario()));
    const { thresholds } = subject.block(0, 20) as BudgetBlock;
    return {
      scenario: scenario(),
      averages: averages(subject, (first) => budgetBlock(scenario(), thresholds, first), 3),
    };
  };

  test("spends less the higher the threshold is; the axis along projections increases", () => {
    const { averages } = pictureOf();
    expect(averages.trials).toBe(60);
    const { value } = averages.projections;
    expect(value.every((each, index) => index === 0 || each <= value[index - 1])).toBe(true);
    const [byProjections] = budget.plots(pictureOf(), scenario(), track(scenario()));
    const { values } = byProjections.x;
    expect(values.every((each, index) => index === 0 || each >= values[index - 1])).toBe(true);
    expect(byProjections.lines.every((line) => line.values.length === values.length)).toBe(true);
  });

  test("has one handle in all its plots, which sets the threshold of the scenario", () => {
    const run = track(scenario());
    for (const { x, name } of budget.plots(pictureOf(), scenario(), run)) {
      const handle = x.handle!;
      expect(handle.value, name).toBe(PAPER);
      expect(handle.valueAt(handle.placeOf(PAPER)), name).toBeCloseTo(PAPER, 6);
      expect(x.marks).toEqual([{ place: handle.placeOf(PAPER), label: "paper: 0.15" }]);
      const { what, scenario: edited } = handle.edit(0.3);
      expect(what).toBe("ET threshold set to 0.3");
      expect(edited).toEqual({
        ...scenario(),
        estimators: { ...scenario().estimators, threshold: { kind: "absolute", epsilon: 0.3 } },
      });
    }
  });

  test("is of all thresholds: another one or other filters change no number, other noise does", () => {
    const run = track(scenario());
    const key = (change: (estimators: ReturnType<typeof scenario>) => void) => {
      const changed = scenario();
      change(changed);
      return budget.subject(changed, run).key;
    };
    const same = key(() => undefined);
    expect(key(({ estimators }) => (estimators.threshold.epsilon = 0.4))).toBe(same);
    expect(key(({ estimators }) => (estimators.enabled = ["kf"]))).toBe(same);
    expect(key(({ estimators }) => (estimators.threshold.kind = "relative"))).not.toBe(same);
    expect(key((changed) => (changed.seed = 5))).not.toBe(same);
  });

  test("a relative threshold has no paper to be compared with", () => {
    const relative = scenario();
    relative.estimators.threshold.kind = "relative";
    const [plot] = budget.plots(pictureOf(), relative, track(relative));
    expect(plot.x.marks).toEqual([]);
  });
});

describe("anchors drawn anew", () => {
  const pictureOf = (name: string) => {
    const scenario = preset(name);
    const subject = draws.subject(scenario, track(scenario));
    return { scenario, averages: averages(subject, (first) => drawsBlock(scenario, first), 2) };
  };

  test("are points over their condition, beside the levels of the fixed ones", () => {
    const picture = pictureOf("tracking-paper");
    const [orientation] = draws.plots(picture, picture.scenario, track(picture.scenario));
    const { values, now } = orientation.x;
    expect(values.length).toBe(40);
    expect(values.every((each, index) => index === 0 || each >= values[index - 1])).toBe(true);
    expect(now).toBe(picture.averages.fixedCondition);
    const [points, levels] = [true, undefined].map((kind) =>
      orientation.lines.filter((line) => line.points === kind),
    );
    expect([points.length, levels.length]).toEqual([3, 3]);
    const { filter, conditions } = picture.averages;
    const worst = conditions.indexOf(Math.max(...conditions));
    const kf = points.find((line) => line.name === "kf")!;
    expect(kf.values[39]).toBeCloseTo((filter.redrawn.angle[worst] * 180) / Math.PI, 12);
    expect(new Set(levels[1].values).size).toBe(1);
    expect(levels[1].values[0]).toBeCloseTo((quantiles(filter.fixed.angle, [0.5])[0] * 180) / Math.PI, 12);
    expect(draws.told?.(picture, picture.scenario)).toContain("±968\u00a0m");
    const redrawn = pictureOf("tracking-paper-redrawn").averages;
    expect(redrawn.halfWidth).toBe(1000);
    expect(redrawn.fixedCondition).toBe(now);
  });

  test("fixed ones in a plane lie beyond every condition", () => {
    const scenario = preset("coplanar-ceiling");
    const flat = { ...scenario, anchors: scenario.anchors.map(([x, y]) => [x, y, 3]) };
    const subject = draws.subject(flat, track(scenario));
    const picture = { scenario: flat, averages: averages(subject, (first) => drawsBlock(flat, first), 1) };
    const [{ x }] = draws.plots(picture, flat, track(scenario));
    expect(x.now).toBe(Infinity);
    expect(x.marks?.[0].label).toContain("in a plane");
    expect(draws.told?.(picture, flat)).not.toMatch(/NaN|undefined/);
  });
});
