import { beforeAll, expect, test } from "vitest";
import { preset, studyBlock, StudySum } from "../../engine";
import { loadEngineForTests } from "../../engine/testing";
import type { Curve, EstimatorCurves } from "../../study";
import { nisBands } from "../../plots/consistency-bands";
import { neesVerdict, nisVerdict } from "./verdicts";

beforeAll(loadEngineForTests);

const TRIALS = 100;
const STEPS = 20;
const flat = (value: number): Curve => ({
  value: new Float64Array(STEPS).fill(value),
  standardError: new Float64Array(STEPS),
});
const filter = (label: string, nees: number, nis = 1): EstimatorCurves => ({
  name: label,
  label,
  angle: flat(1),
  position: flat(1),
  nees: flat(nees),
  neesDegreesOfFreedom: 6,
  nis: flat(nis),
  nisDegreesOfFreedom: new Float64Array(STEPS).fill(12),
  eventRate: flat(0),
  failures: new Uint32Array(STEPS),
});

test("filters within chance are not spoken of", () => {
  expect(neesVerdict([filter("KF", 1), filter("UC-KF", 1.05)], TRIALS)).toBeNull();
  expect(nisVerdict([filter("KF", 1)], TRIALS)).toBeNull();
  expect(neesVerdict([], TRIALS)).toBeNull();
});

test("one that is too sure is named, with its mean and what chance reaches", () => {
  const told = neesVerdict([filter("KF", 1), filter("UC-KF", 1.8)], TRIALS);
  expect(told).toMatch(/^UC-KF is too sure of itself: mean NEES up to 1\.80 \(by chance 1\.[2-4]\d\)\.$/);
  expect(nisVerdict([filter("KF", 1, 2), filter("UC-KF", 1)], TRIALS)).toMatch(
    /^KF is too sure .* NIS up to 2\.00/,
  );
  const all = ["A", "B", "C"].map((label) => filter(label, 3));
  expect(neesVerdict(all, TRIALS)).toMatch(/^All filters are too sure of themselves/);
});

test("one that claims too much error is named where none is too sure", () => {
  const told = neesVerdict([filter("KF", 0.5), filter("UC-KF", 1)], TRIALS);
  expect(told).toMatch(/^KF knows more than it claims: mean NEES down to 0\.500/);
  expect(neesVerdict([filter("KF", 0.5), filter("UC-KF", 2)], TRIALS)).toMatch(/^UC-KF is too sure/);
});

test("the same excess of few trials is chance; trials that failed do not count", () => {
  expect(neesVerdict([filter("KF", 1.35)], TRIALS)).not.toBeNull();
  expect(neesVerdict([filter("KF", 1.35)], 10)).toBeNull();
  expect(
    neesVerdict([{ ...filter("KF", 1.35), failures: new Uint32Array(STEPS).fill(90) }], TRIALS),
  ).toBeNull();
});

test("the preset of the confident filter is found out by its innovations, the room is not", () => {
  const studyOf = (name: string) => {
    const scenario = preset(name);
    const sum = new StudySum(scenario);
    for (const first of [0, 20, 40]) sum.push(studyBlock(scenario, first, 20));
    return sum.read();
  };
  const sure = studyOf("overconfident");
  expect(neesVerdict(sure.estimators, sure.trials)).toContain("too sure");
  expect(nisVerdict(sure.estimators, sure.trials)).toContain("too sure");
  const room = studyOf("room");
  const raw = room.estimators.filter(({ name }) => name.startsWith("eskf"));
  // The first step of these is a thousand times off: it starts from a guess across the room.
  expect(Math.max(...raw.map(({ nis }) => nis.value[0]))).toBeGreaterThan(100);
  expect(nisVerdict(raw, room.trials)).toBeNull();
  const [band] = nisBands(raw, room.trials);
  expect(band.low).toBeLessThan(1);
  expect(band.high).toBeGreaterThan(1);
});
