import { beforeAll, describe, expect, test } from "vitest";
import { completeIndoor, indoorBlock, indoorPresets, indoorTrialsPerBlock, IndoorSum } from "../../engine";
import { loadEngineForTests } from "../../engine/testing";
import type { FilterName } from "../../generated/FilterName";
import type { IndoorScenario } from "../../generated/IndoorScenario";
import { shares } from "./distribution";
import { indoor, withDefaultBeacons } from "./family";
import { FILTERS, SHOWN_FIRST } from "./filters";
import { type Level, lessons } from "./lessons";
import { plots } from "./plots";
import { runReadings, stepReadings, studyReadings } from "./readings";
import { presetOf, runOf } from "./run";
import { study } from "./study";
import { describe as told, verdict } from "./verdict";

beforeAll(loadEngineForTests);

const changed = (name: string, change: (scenario: IndoorScenario) => void): IndoorScenario => {
  const scenario = presetOf(name);
  change(scenario);
  return scenario;
};

describe("filters", () => {
  test("are those of the engine, each with a look of its own by mark and by dash", () => {
    const { filters } = completeIndoor({ version: 1 });
    expect(filters.enabled.toSorted()).toEqual(FILTERS.map(({ name }) => name).toSorted());
    expect(new Set(FILTERS.map(({ token, mark }) => token + mark)).size).toBe(FILTERS.length);
    expect(new Set(FILTERS.map(({ token, dash }) => token + dash.join())).size).toBe(FILTERS.length);
    const first = FILTERS.filter(({ name }) => SHOWN_FIRST.includes(name));
    expect(new Set(first.map(({ mark }) => mark)).size).toBe(first.length);
    expect(new Set(first.map(({ token }) => token)).size).toBe(first.length);
  });
});

describe("the family", () => {
  test("knows its documents, and has four beacons again where the last one goes", () => {
    const scenario = presetOf("indoor-u");
    expect([indoor.claims(scenario), indoor.claims({ version: 1, anchors: [] })]).toEqual([true, false]);
    const two = indoor.withoutAnchors(scenario, [0, 2]);
    expect(two.beacons).toEqual([scenario.beacons[1], scenario.beacons[3]]);
    expect(indoor.withoutAnchors(two, [0, 1]).beacons).toEqual(scenario.beacons);
    expect(indoor.validate({ ...scenario, imu: { ...scenario.imu, rate_hz: -1 } })[0].path).toBe(
      "imu.rate_hz",
    );
    expect(indoor.room(scenario)).toMatchObject({ dimension: 3, movable: true, anchors: scenario.beacons });
  });
});

describe("a run", () => {
  test("of every preset can be drawn, plotted, read and said", () => {
    for (const { name } of indoorPresets()) {
      const run = runOf(presetOf(name));
      expect(run.filters.map((filter) => filter.name)).toEqual(SHOWN_FIRST);
      for (const spec of plots(run.scenario, run)) {
        expect(spec.lines.length, name).toBeGreaterThanOrEqual(4);
        for (const line of spec.lines) expect(line.values.length).toBe(run.steps);
      }
      expect(runReadings(run).every(({ numbers }) => numbers !== null)).toBe(true);
      expect(told(run).length, name).toBeGreaterThan(60);
    }
  });

  test("has the errors of the step in one table and those of the run in the other", () => {
    const run = runOf(presetOf("indoor-u"));
    const [last, whole] = [stepReadings(run, run.steps - 1), runReadings(run)];
    run.filters.forEach((filter, index) => {
      expect(last[index].numbers?.position).toBe(filter.positionErrors.at(-1));
      const squares = filter.positionErrors.reduce((sum, error) => sum + error * error, 0);
      expect(whole[index].numbers?.position).toBeCloseTo(Math.sqrt(squares / run.steps), 12);
    });
  });

  test("shows the least singular value where it is not the largest", () => {
    const run = runOf(presetOf("indoor-stair"));
    const lines = plots(run.scenario, run)[2].lines;
    expect(lines.map(({ name }) => name)).toContain("ekf-least");
    expect(lines.map(({ name }) => name)).not.toContain("mekf-least");
  });

  test("says what the lesson of its preset is", () => {
    const say = (name: string) => told(runOf(presetOf(name)));
    expect(say("indoor-u")).toMatch(
      /EKF’s R has grown by 1\.26\d.*all by retraction: that alone equals it to/,
    );
    expect(say("indoor-u")).toContain("MEKF, which integrates exactly");
    expect(say("indoor-stair")).toMatch(/grown by 1\.97\d.*EKFRie is \d(\.\d)? times as good as EKF/);
    expect(say("indoor-matched")).toContain("‘disc’ samples match Euler’s rule");
    expect(say("indoor-gravity")).toContain("whose integration matches ‘mean’ samples");
    expect(say("indoor-static")).toContain("All filters agree");
    expect(say("indoor-tumble")).toContain("EKFRie’s orientation is worse");
  });

  test("says it where nothing runs", () => {
    expect(told(runOf(changed("indoor-u", ({ filters }) => (filters.enabled = []))))).toBe(
      "No filter is switched on.",
    );
  });
});

describe("lessons", () => {
  const level = (name: FilterName, position: number, more: Partial<Level> = {}): Level => ({
    ...{ name, label: name, position, angle: 0.04, stretch: 1, nees: 10 },
    ...more,
  });
  const text = (levels: Level[], convention: "sample" | "disc" = "sample") =>
    lessons(levels, convention).map((finding) => finding.text);

  test("a loss by retraction is called one, and transport that matters is not hidden", () => {
    expect(text([level("ekf", 1), level("ekf-retraction", 1.03), level("ekf-rie", 1.03)])).toContain(
      "EKFRie is 3 % worse than EKF, all by retraction: that alone equals it to six digits.",
    );
    expect(text([level("ekf", 1), level("ekf-retraction", 0.8), level("ekf-rie", 1.6)])).toContain(
      "EKFRie is 60 % worse than EKF; retraction alone is 2 times as good as it.",
    );
  });

  test("a filter that fits the samples worse is told", () => {
    expect(text([level("ekf-rie", 0.05), level("mekf", 0.3)], "disc").join(" ")).toContain("6 times as bad");
  });
});

describe("the study", () => {
  test("is sketched by fewer trials, and by the same blocks as the engine's", () => {
    const scenario = presetOf("indoor-u");
    const subject = study.subject(scenario, runOf(scenario));
    expect(subject.plan.perBlock).toBe(indoorTrialsPerBlock());
    expect(subject.plan.most % subject.plan.perBlock).toBe(0);
    expect(subject.sketch?.key).not.toBe(subject.key);
    const sum = new IndoorSum(scenario);
    sum.push(indoorBlock(scenario, 0));
    const report = sum.read();
    sum.free();
    expect(report.trials).toBe(20);
    const specs = study.plots({ scenario, averages: report }, scenario, runOf(scenario));
    const cdf = specs.find(({ name }) => name === "indoor-cdf-position")!;
    for (const { values } of cdf.lines) {
      expect(values.at(-1)).toBe(100);
      expect(values.every((value, index) => index === 0 || value >= values[index - 1])).toBe(true);
    }
    expect(studyReadings(report)[0].numbers?.position).toBe(report.filters[0].summary.position.value);
    expect(verdict(report, "sample")).toMatch(/^Mean over 20 trials, ±\d\.\d+ % at most\. .*R has grown/);
  });

  test("a filter that fails in a third of the trials stays below the top", () => {
    const { values } = shares([1, 2], Float64Array.of(1, 2), 3);
    expect([...values].map(Math.round)).toEqual([33, 67]);
  });

  test("shares are counted with the standard errors of shares", () => {
    const { values, standardErrors } = shares([1, 2, 2, 4], Float64Array.of(0.5, 1, 2, 4), 4);
    expect([...values]).toEqual([0, 25, 75, 100]);
    expect(standardErrors![1]).toBeCloseTo(100 * Math.sqrt((0.25 * 0.75) / 4), 12);
    expect([standardErrors![0], standardErrors![3]]).toEqual([0, 0]);
  });
});

test("another path brings its beacons, and one that is too long for the IMU is left to be refused", () => {
  const scenario = presetOf("indoor-u");
  const onBridge = withDefaultBeacons({ ...scenario, path: "bridge" });
  expect(onBridge.beacons).toEqual(presetOf("indoor-bridge").beacons);
  const tooLong = { ...scenario, path: "stair" as const, imu: { ...scenario.imu, rate_hz: 200 } };
  expect(withDefaultBeacons(tooLong)).toBe(tooLong);
  expect(indoor.validate(tooLong)).not.toEqual([]);
});
