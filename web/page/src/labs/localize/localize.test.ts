import { beforeAll, describe, expect, test } from "vitest";
import { localizationBlock, localizationTrialsPerBlock, preset } from "../../engine";
import { loadEngineForTests } from "../../engine/testing";
import type { Scenario } from "../../scenario";
import type { SweepBlock } from "../../workers/messages";
import { poseIn } from "./cloud";
import { unseenMirrors } from "./layers";
import { LOCALIZERS } from "./localizers";
import { sweepPlots } from "./plots";
import { boundReadings, localizerReadings } from "./readings";
import { runOf } from "./run";
import { study, zetasBy } from "./sweep";
import { describe as sentenceOf } from "./told";
import { CLOUD, hintOf, SHOWN } from "./view";

beforeAll(loadEngineForTests);

const paper = (zeta_db: number, changes: Partial<Scenario["localize"]> = {}): Scenario => {
  const scenario = preset("localization-paper");
  return { ...scenario, noise: { kind: "toa", zeta_db }, localize: { ...scenario.localize, ...changes } };
};

describe("localizers", () => {
  test("are those of the engine, each with a look of its own but for the one that equals another", () => {
    expect(preset("room").localize.enabled.toSorted()).toEqual(LOCALIZERS.map(({ name }) => name).toSorted());
    const looks = LOCALIZERS.filter(({ name }) => name !== "suc-tls").map(({ token, mark }) => token + mark);
    expect(new Set(looks).size).toBe(looks.length);
  });
});

describe("hints", () => {
  test("that no hand should have written are not followed", () => {
    const view = (cloud: unknown) => ({ view: { cloud } });
    expect(hintOf(view(20), CLOUD)).toBe(20);
    for (const bad of ["many", 0, 1.5, 1e9, null]) expect(hintOf(view(bad), CLOUD)).toBe(CLOUD.first);
    expect(hintOf({ view: null }, SHOWN)).toBe(SHOWN.first);
  });
});

describe("a run", () => {
  test("has the trial drawn in its clouds", () => {
    for (const name of ["room", "planar"]) {
      const run = runOf({ ...preset(name), view: { trial: 3, cloud: 5 } });
      for (const { estimate, pose } of run.estimates) {
        const cloud = run.clouds.find((entry) => entry.name === estimate.name)!;
        expect(cloud.count).toBe(5);
        const again = poseIn(cloud, 3, run.truth, run.dimension);
        again.positions.forEach((value, i) => expect(value).toBeCloseTo(pose.positions[i], 9));
        again.orientations.forEach((value, i) => expect(value).toBeCloseTo(pose.orientations[i], 9));
      }
    }
  });

  test("over O(3) at much noise shows mirrored bodies, over SO(3) only those of LS", () => {
    const mirrorsIn = (manifold: "o" | "so") => {
      const run = runOf(paper(20, { manifold }));
      const rates = localizerReadings(run, "cloud").map(({ name, reflections }) => [name, reflections ?? 0]);
      return { run, rates: Object.fromEntries(rates) as Record<string, number> };
    };
    const { run, rates } = mirrorsIn("o");
    expect(rates["ouc-ls"]).toBeGreaterThan(0.2);
    expect(
      unseenMirrors(run).length + run.estimates.filter(({ estimate }) => estimate.reflected).length,
    ).toBe(Object.values(rates).filter((rate) => rate > 0).length);
    expect(sentenceOf(run)).toContain("mirror the body in");
    const proper = mirrorsIn("so").rates;
    expect(Object.keys(proper).filter((name) => proper[name] > 0)).toEqual(["ls"]);
  });

  test("reads the same in one trial as the average over it alone", () => {
    const run = runOf({ ...paper(60), view: { cloud: 1 } });
    const [one, all] = [localizerReadings(run, "trial"), localizerReadings(run, "cloud")];
    one.forEach(({ name, angle, position, iterations }, index) => {
      const other = all[index];
      expect([name, iterations]).toEqual([other.name, other.iterations]);
      if (angle !== null) expect(other.angle).toBeCloseTo(angle, 10);
      if (position !== null) expect(other.position).toBeCloseTo(position, 10);
    });
    expect(boundReadings(run, "trial").map(({ name }) => name)).toEqual(
      boundReadings(run, "cloud").map(({ name }) => name),
    );
  });

  test("says it where nothing runs", () => {
    expect(sentenceOf(runOf(paper(60, { enabled: [] })))).toBe("No localizer is switched on.");
  });
});

describe("the sweep", () => {
  test("is the same whatever the scenario's own noise is, and sketched over fewer points", () => {
    const [quiet, loud] = [paper(80), paper(20)].map((scenario) => study.subject(scenario, runOf(scenario)));
    expect(quiet.key).toBe(loud.key);
    expect(quiet.sketch?.key).not.toBe(quiet.key);
    const other = paper(80, { manifold: "o" });
    expect(study.subject(other, runOf(other)).key).not.toBe(quiet.key);
    expect(quiet.plan.perBlock).toBe(localizationTrialsPerBlock());
    expect(quiet.plan.most % quiet.plan.perBlock).toBe(0);
  });

  test("gives curves that fall to their bounds, and a press on them sets the noise", () => {
    const scenario = paper(60);
    const run = runOf(scenario);
    const subject = study.subject(scenario, run);
    const sum = subject.openSum();
    expect(sweepPlots(zetasBy(5), null, scenario, run).every(({ lines }) => lines.length === 0)).toBe(true);
    sum.push(localizationBlock(subject.block(0, 50) as SweepBlock));
    const [orientation] = study.plots({ scenario, averages: sum.read() }, scenario, run);
    sum.free();
    expect(orientation.x.now).toBe(60);
    const line = (name: string) => orientation.lines.find((entry) => entry.name === name)!;
    const ratio = line("ouc-ls").values[16] / line("uc_crb").values[16];
    expect(Math.abs(ratio - 1)).toBeLessThan(3 / Math.sqrt(2 * 150));
    expect(line("ouc-ls").values[0]).toBeGreaterThan(100);
    const edit = orientation.x.edit!(37.4);
    expect((edit.scenario as Scenario).noise).toEqual({ kind: "toa", zeta_db: 37 });
    expect(edit.what).toBe("ζ set to 37 dB");
  });
});
