import { beforeAll, describe, expect, test } from "vitest";
import { chiSquaredInterval, preset, studyBlock, StudySum, track, trialsPerBlock } from "../../engine";
import { loadEngineForTests } from "../../engine/testing";
import type { Run } from "../../run";
import { boundReadings, estimatorReadings, studyReadings } from "./readings";

beforeAll(loadEngineForTests);

const STEP = 12;

describe("the rows of a run", () => {
  test("hold its errors and bounds at the step", () => {
    const run = track(preset("room"));
    const rows = estimatorReadings(run, STEP);
    expect(rows.map(({ name }) => name)).toEqual(run.estimators.map(({ name }) => name));
    rows.forEach(({ errors, consistency }, index) => {
      const estimator = run.estimators[index];
      expect(errors).toEqual({
        angle: estimator.orientationErrors[STEP],
        position: estimator.positionErrors[STEP],
      });
      expect(consistency?.ratio).toBe(estimator.nees[STEP] / estimator.neesDegreesOfFreedom);
    });
    const [bound] = boundReadings(run, STEP);
    expect(bound.errors?.angle).toBe(run.bounds.find(({ name }) => name === bound.name)?.orientation[STEP]);
  });

  test("say where NEES leaves its band, and nothing once an estimator stopped", () => {
    const run = track(preset("room"));
    const [least, most] = chiSquaredInterval(run.estimators[0].neesDegreesOfFreedom, 0.998);
    const verdict = (nees: number) => {
      const [first, ...others] = run.estimators;
      const changed: Run = {
        ...run,
        estimators: [{ ...first, nees: first.nees.map(() => nees) }, ...others],
      };
      return estimatorReadings(changed, STEP)[0].consistency?.verdict;
    };
    expect([least * 0.99, least * 1.01, most * 0.99, most * 1.01].map(verdict)).toEqual([
      "below",
      "within",
      "within",
      "above",
    ]);
    const stopped = { ...run.estimators[0], stopped: { step: STEP, sentence: "Why." } };
    const [row] = estimatorReadings({ ...run, estimators: [stopped] }, STEP);
    expect(row).toMatchObject({
      errors: null,
      consistency: null,
      remark: `stopped at step ${STEP + 1}: Why.`,
    });
  });
});

test("the rows of a study hold its root mean square errors", () => {
  const scenario = preset("room");
  const sum = new StudySum(scenario);
  sum.push(studyBlock(scenario, 0, trialsPerBlock()));
  const study = sum.read();
  sum.free();
  const { estimators, bounds } = studyReadings(study, STEP);
  estimators.forEach(({ errors, consistency }, index) => {
    expect(errors?.angle).toBe(study.estimators[index].angle.value[STEP]);
    expect(consistency?.ratio).toBe(study.estimators[index].nees.value[STEP]);
  });
  expect(bounds.map(({ name }) => name)).toEqual(
    boundReadings(track(scenario), STEP).map(({ name }) => name),
  );
});
