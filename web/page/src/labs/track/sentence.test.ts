import { beforeAll, describe, expect, test } from "vitest";
import { DEGREES_PER_RADIAN, formatReading } from "../../controls/format";
import { chiSquaredInterval, preset, presets, track } from "../../engine";
import { loadEngineForTests } from "../../engine/testing";
import type { EstimatorRun, Run } from "../../run";
import { describe as say } from "./sentence";

beforeAll(loadEngineForTests);

const runOf = (name: string): Run => track(preset(name));
const estimatorOf = (run: Run, name: string) => run.estimators.find((entry) => entry.name === name)!;
const changed = (run: Run, name: string, part: Partial<EstimatorRun>): Run => ({
  ...run,
  estimators: run.estimators.map((entry) => (entry.name === name ? { ...entry, ...part } : entry)),
});
const filled = (length: number, value: number) => new Float64Array(length).fill(value);

test("every step of every preset is told in one to three sentences, without holes", () => {
  for (const { name } of presets()) {
    const run = runOf(name);
    for (let step = 0; step < run.steps; step++) {
      const text = say(run, step);
      expect(text, `${name}, step ${step}`).toMatch(/^[A-Z0-9x-z].*\.$/);
      expect(text).not.toMatch(/NaN|Infinity|undefined|null|–|\|\|/);
    }
  }
});

test("the estimator that was nearest so far is named, with its error and bound at the step", () => {
  const run = runOf("room");
  for (const step of [5, 30, run.steps - 1]) {
    const meanSquare = ({ orientationErrors }: EstimatorRun) => {
      let sum = 0;
      for (let at = 0; at <= step; at++) sum += orientationErrors[at] ** 2;
      return sum;
    };
    const [best] = run.estimators.toSorted((one, other) => meanSquare(one) - meanSquare(other));
    const bound = run.bounds.find(({ name }) =>
      best.name === "eskf-raw" ? name === "posterior_crb_raw" : name === "posterior_crb",
    )!;
    const degrees = (angle: number) => formatReading(angle * DEGREES_PER_RADIAN);
    expect(say(run, step)).toContain(
      `${best.label}, ${degrees(best.orientationErrors[step])}° and ${formatReading(best.positionErrors[step])} m off; ` +
        `the bound is ${degrees(bound.orientation[step])}° and ${formatReading(bound.position[step])} m.`,
    );
  }
});

test("projections are counted up to the step", () => {
  const run = runOf("coplanar-ceiling");
  const { events } = estimatorOf(run, "et-kf");
  const count = (step: number) => events.subarray(0, step + 1).reduce((sum, event) => sum + event, 0);
  expect(count(40)).toBeLessThan(count(run.steps - 1));
  expect(say(run, 40)).toContain(`ET-KF projected at ${count(40)} of 41 steps so far.`);
  expect(say(run, run.steps - 1)).toContain(
    `ET-KF projected at ${count(run.steps - 1)} of ${run.steps} steps.`,
  );
});

describe("geometry", () => {
  test("under a ceiling height is weak, by as much as the bound's covariance says, and the plane is why", () => {
    const run = runOf("coplanar-ceiling");
    const step = run.steps - 1;
    const covariance = run.bounds
      .find(({ name }) => name === "posterior_crb")!
      .positionCovariances.subarray(9 * step);
    const largest = largestEigenvalue(covariance);
    const across = (covariance[0] + covariance[4] + covariance[8] - largest) / 2;
    const ratio = Number(Math.sqrt(largest / across).toPrecision(2));
    expect(ratio).toBeGreaterThan(5);
    expect(say(run, step)).toContain(
      `Five anchors lie within ${formatReading(run.geometry.anchors.plane!.thickness)} m of one plane: ` +
        `height is known ${ratio} times worse than position in it.`,
    );
  });

  test("anchors all round leave nothing to complain of", () => {
    const run = runOf("room");
    expect(say(run, run.steps - 1)).not.toMatch(/anchors|worse/);
  });

  test("what cannot be seen at all is said by the engine", () => {
    const run = runOf("three-anchors");
    expect(run.geometry.unseen).not.toBeNull();
    expect(say(run, 20)).toContain(run.geometry.unseen!.replace("||s||^2", "‖s‖²").slice(0, 60));
  });

  test("anchors on a wall of the plane make the other coordinate weak", () => {
    const scenario = preset("planar");
    const anchors = scenario.anchors.map(([x], index) => [x + index, 0.01 * index]);
    const run = track({ ...scenario, anchors });
    expect(say(run, run.steps - 1)).toMatch(
      /^.*Four anchors lie within .* m of one line: y is known .* times worse than position along it\./,
    );
  });
});

describe("consistency", () => {
  test("errors beyond the covariance are told with the worst of them", () => {
    const run = runOf("room");
    const [, most] = chiSquaredInterval(12, 0.998);
    const kf = changed(run, "kf", { nees: filled(run.steps, most + 1) });
    expect(say(kf, 10)).toContain(`KF is over-confident: NEES ${formatReading(most + 1)}`);
    const both = changed(kf, "ortho", { nees: filled(run.steps, 400) });
    expect(say(both, 10)).toContain("KF and KF-ortho are over-confident: NEES up to 400");
  });

  test("errors within the band are not", () => {
    const run = runOf("room");
    const [least, most] = chiSquaredInterval(12, 0.998);
    for (const nees of [least + 0.01, most - 0.01])
      expect(say(changed(run, "kf", { nees: filled(run.steps, nees) }), 10)).not.toMatch(/NEES/);
  });
});

test("an estimator that stopped comes first, with its reason", () => {
  const run = changed(runOf("room"), "uc-kf", { stopped: { step: 7, sentence: "The ranges ran out" } });
  expect(say(run, 7)).toMatch(/^UC-KF stopped at step 8: The ranges ran out\. /);
  expect(say(run, 6)).not.toContain("stopped");
});

test("a mirrored body is told, a turned one is not", () => {
  const run = runOf("room");
  const { orientations } = estimatorOf(run, "uc-kf");
  const mirrored = orientations.map((entry, index) => (index % 3 === 0 ? -entry : entry));
  expect(say(changed(run, "uc-kf", { orientations: mirrored }), 10)).toContain(
    "UC-KF reports a mirrored body",
  );
  const turned = orientations.map((entry, index) => (index % 3 === 2 ? entry : -entry));
  expect(say(changed(run, "uc-kf", { orientations: turned }), 10)).not.toContain("mirrored");
});

test("without estimators that is said", () => {
  expect(say({ ...runOf("room"), estimators: [] }, 3)).toContain("No estimator is switched on.");
});

/** By power iteration, unlike the page. */
function largestEigenvalue(matrix: Float64Array): number {
  let vector = [1, 1.1, 0.9];
  let length = 0;
  for (let i = 0; i < 2000; i++) {
    const next = [0, 3, 6].map((row) =>
      vector.reduce((sum, value, column) => sum + matrix[row + column] * value, 0),
    );
    length = Math.hypot(...next);
    vector = next.map((value) => value / length);
  }
  return length;
}
