import { beforeAll, describe, expect, test } from "vitest";
import {
  anchorlessBlock,
  anchorlessPreset,
  anchorlessPresets,
  anchorlessTrialsPerBlock,
  completeAnchorless,
} from "../../engine";
import { loadEngineForTests } from "../../engine/testing";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import type { StampBlock } from "../../workers/messages";
import { withAccelerometers } from "./controls/switches";
import { ESTIMATORS, ORDER, senses } from "./estimators";
import { anchorless } from "./family";
import { describe as told, sweepVerdict } from "./findings";
import { evidenceOf, gaugeOf, placed, placedBack, seen, turned, turnedBack, withGauge } from "./gauge";
import { handles } from "./handles";
import { arrowSeconds, hintOf, ERRORS } from "./hints";
import { plots } from "./plots";
import { boundReadings, runReadings, studyReadings } from "./readings";
import { runOf } from "./run";
import { averagesAt, sweep } from "./sweep";

beforeAll(loadEngineForTests);

const paper = () => anchorlessPreset("kinematics-paper");
const turnedPaper = () => withGauge(paper(), { degrees: 37, mirrored: true, shift: [10, -250] });

describe("estimators", () => {
  test("are those of the engine, each with a look of its own by mark and by dash", () => {
    for (const name of ORDER)
      expect(completeAnchorless({ ...paper(), estimators: { enabled: [name] } }).estimators.enabled).toEqual([
        name,
      ]);
    expect(ESTIMATORS).toHaveLength(15);
    expect(new Set(ESTIMATORS.map(({ token, mark }) => token + mark)).size).toBe(15);
    expect(new Set(ESTIMATORS.map(({ token, dash }) => token + dash.join())).size).toBe(15);
    const first = ESTIMATORS.filter(({ name }) => paper().estimators.enabled.includes(name));
    expect(new Set(first.map(({ mark }) => mark)).size).toBe(first.length);
    expect(new Set(first.map(({ token }) => token)).size).toBe(first.length);
  });

  test("that read accelerometers go and come back with them", () => {
    const { enabled } = paper().estimators;
    const without = withAccelerometers(enabled, false, enabled);
    expect([senses(enabled), senses(without), without.length]).toEqual([true, false, 3]);
    expect(withAccelerometers(without, true, enabled)).toEqual(enabled);
    expect(senses(withAccelerometers([], true, undefined))).toBe(true);
  });
});

describe("the gauge", () => {
  test("goes there and back, exactly for quarter turns", () => {
    for (const degrees of [0, 30, 90, -90, 180, 270, -179]) {
      const gauge = { degrees, mirrored: true, shift: [3, 4], pivot: [-5, 7] };
      placedBack(gauge, placed(gauge, [11, 13])).forEach((value, i) =>
        expect(value).toBeCloseTo([11, 13][i], 12),
      );
      turnedBack(gauge, turned(gauge, [2, -1])).forEach((value, i) =>
        expect(value).toBeCloseTo([2, -1][i], 13),
      );
    }
    expect(turned({ degrees: 90, mirrored: false, shift: [0, 0], pivot: [0, 0] }, [2, 1])).toEqual([-1, 2]);
  });

  test("changes no distance and turns all arrows alike; another change of the nodes is found out", () => {
    const evidence = evidenceOf(turnedPaper(), [-5, 0, 5]);
    for (const value of Object.values(evidence)) expect(value).toBeLessThan(1e-9);
    expect(seen(turnedPaper())[0][0]).not.toEqual(paper().coefficients[0][0]);
    // The same measure of a network of which one velocity is another one is not small.
    const scenario = turnedPaper();
    const other = { ...scenario, coefficients: structuredClone(scenario.coefficients) };
    seen(other)[1][3][0] += 1;
    expect(evidenceOf(other, [5]).distance).toBeGreaterThan(0.1);
  });

  test("leaves errors from distances as they are; accelerometers have a frame of their own", () => {
    const [one, other] = [runOf(paper()), runOf(turnedPaper())];
    one.trial.estimators.forEach(({ name, coefficient_errors }, index) => {
      const turnedErrors = other.trial.estimators[index].coefficient_errors;
      const changes = turnedErrors.map((error, l) => Math.abs(error / coefficient_errors[l] - 1));
      if (senses([name])) expect(Math.max(...changes), name).toBeGreaterThan(1e-4);
      else expect(Math.max(...changes), name).toBeLessThan(1e-6);
    });
  });

  test("that no hand should have written is none", () => {
    for (const gauge of ["round", { degrees: "x" }, { degrees: 10, shift: [1], pivot: [0, 0] }, null])
      expect(gaugeOf({ ...paper(), view: { gauge } }).degrees).toBe(0);
    expect(withGauge(turnedPaper(), { degrees: 0, mirrored: false, shift: [0, 0] }).view).toEqual({});
    expect(hintOf({ view: { error_scale: "big" } }, ERRORS)).toBeNull();
    expect(arrowSeconds({ ...paper(), view: { arrow_seconds: -1 } })).toBe(20);
  });
});

describe("nodes", () => {
  test.each([paper, turnedPaper])("are moved, added and removed where they are seen", (make) => {
    const scenario = make();
    const { anchors } = anchorless.room(scenario);
    const moved = anchorless.withAnchors(
      scenario,
      anchors.map((anchor, node) => (node === 2 ? [300, 400] : [...anchor])),
    );
    expect(anchorless.room(moved).anchors[2]).toEqual([300, 400]);
    moved.coefficients[0].forEach((point, node) => {
      if (node !== 2) expect(point).toBe(scenario.coefficients[0][node]);
    });
    const more = anchorless.withAnchors(scenario, [...anchors, [1, 2]]);
    expect(more.coefficients.map((points) => points.length)).toEqual([11, 11, 11]);
    expect(anchorless.withoutAnchors(more, [10]).coefficients).toEqual(scenario.coefficients);
    expect(anchorless.validate(more)).toEqual([]);
  });

  test.each([paper, turnedPaper])("have arrows whose tips set velocity and acceleration", (make) => {
    const scenario = make();
    const tips = handles(scenario);
    expect(tips).toHaveLength(20);
    for (const id of ["velocity 3", "acceleration 3"]) {
      const tip = tips.find((handle) => handle.id === id)!;
      const moved = tip.move(scenario, [500, -200]);
      expect(handles(moved).find((handle) => handle.id === id)!.place).toEqual([
        expect.closeTo(500, 5),
        expect.closeTo(-200, 5),
      ]);
      expect(moved.coefficients[0]).toBe(scenario.coefficients[0]);
    }
  });
});

describe("a run", () => {
  test("of every preset can be drawn, plotted, read and said", () => {
    for (const { name } of anchorlessPresets()) {
      const run = runOf(anchorlessPreset(name));
      expect(run.truth.positions).toHaveLength(run.steps * run.dimension);
      for (const spec of plots(run.scenario, run)) {
        expect(spec.lines.length, `${name}, ${spec.name}`).toBeGreaterThan(0);
        for (const line of spec.lines) expect(line.values).toHaveLength(spec.x.values.length);
      }
      for (const { errors, remark } of runReadings(run))
        expect(errors !== null || remark.length > 20).toBe(true);
      const bounds = boundReadings(run.bounds, run.scenario.estimators.enabled);
      expect(bounds.map(({ errors }) => errors.length)).toEqual([3, 3]);
      expect(told(run).length, name).toBeGreaterThan(60);
      expect(run.covariances("distances", 0)).toHaveLength(run.anchors.length * run.dimension ** 2);
      expect(run.tipCovariances("accelerometers", 1)).toHaveLength(run.anchors.length * run.dimension ** 2);
    }
  });

  test("stands beside its bounds at each instant, those of what is switched on", () => {
    const scenario = { ...paper(), estimators: { ...paper().estimators, enabled: [...ORDER] } };
    const bounded = (of: KinematicsScenario) =>
      plots(of, runOf(of))
        .slice(0, 2)
        .map(({ lines }) => lines.filter(({ token }) => token === "bound"));
    for (const [distances, sensed] of bounded(scenario)) {
      expect([distances.name, sensed.name]).toEqual(["crb-distances", "crb-accelerometers"]);
      distances.values.forEach((value, k) => expect(value).toBeGreaterThan(sensed.values[k]));
    }
    const enabled = withAccelerometers(scenario.estimators.enabled, false, undefined);
    const without = bounded({ ...scenario, estimators: { ...scenario.estimators, enabled } });
    expect(without.map(({ length }) => length)).toEqual([1, 1]);
  });

  test("is seen as far as the tips of its arrows, and no farther", () => {
    for (const { name } of anchorlessPresets()) {
      const scenario = anchorlessPreset(name);
      const { anchors, extent } = anchorless.room(scenario);
      expect(extent).toHaveLength(3 * anchors.length);
      for (const { place } of handles(scenario)) expect(extent).toContainEqual(place);
    }
  });

  test("says which estimator cannot, and why", () => {
    expect(told(runOf(anchorlessPreset("kinematics-four")))).toContain("gives nothing");
    const none = { ...paper(), estimators: { ...paper().estimators, enabled: [] } };
    expect(told(runOf(none))).toBe("No estimator is switched on.");
  });

  test("without noise has no bound, and says so", () => {
    const exact: KinematicsScenario = { ...paper(), noise: { ...paper().noise, sigma_distance: 0 } };
    const run = runOf(exact);
    expect(run.covariances("distances", 0)).toBeNull();
    expect(boundReadings(run.bounds, exact.estimators.enabled)[0].remark.length).toBeGreaterThan(20);
  });
});

describe("the sweep", () => {
  test("is the same whatever the stamps and the gauge are, and sketched over fewer", () => {
    const few = anchorlessPreset("kinematics-sparse");
    const [one, other] = [paper(), withGauge(few, { degrees: 10 })].map((scenario) =>
      sweep.subject(scenario, runOf(few)),
    );
    expect(one.key).toBe(other.key);
    expect(one.sketch?.key).not.toBe(one.key);
    expect(one.plan.perBlock).toBe(anchorlessTrialsPerBlock());
  });

  test("gives curves beside their bounds, and a press on them sets K", () => {
    const scenario = paper();
    const run = runOf(scenario);
    const subject = sweep.subject(scenario, run).sketch!;
    const { counts } = subject.block(0, 20) as StampBlock;
    const sum = subject.openSum();
    sum.push(anchorlessBlock((subject.block(0, 20) as StampBlock).scenario, counts, 0));
    const averages = sum.read();
    sum.free();
    const at100 = studyReadings(averagesAt(averages, 90));
    expect(averagesAt(averages, 90).stamps).toBe(100);
    for (const { errors, standardErrors } of at100)
      errors!.forEach((error, l) => {
        expect(standardErrors![l]).toBeGreaterThan(0);
        expect(standardErrors![l]).toBeLessThan(error);
      });
    const [position, velocity] = sweep.plots({ scenario, averages }, scenario, run);
    expect([...velocity.x.values]).toEqual([10, 30, 100]);
    const at = (name: string) => velocity.lines.find((line) => line.name === name)!.values[2];
    // 15.1 and 14.8 mm/s over 1000 trials; 20 trials of 20 coordinates know it to a sixth at worst.
    expect(at("crb-distances")).toBeCloseTo(0.0151, 3);
    expect(Math.abs(at("maximum-likelihood") / at("crb-distances") - 1)).toBeLessThan(0.5);
    const edit = position.x.edit!(37.4);
    expect((edit.scenario as KinematicsScenario).stamps).toEqual({
      kind: "regular",
      first: -5,
      last: 5,
      count: 37,
    });
    expect(sweepVerdict(averages)).toContain("bound in velocity");
  });
});
