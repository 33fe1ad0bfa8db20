import { SweepSum } from "../../engine";
import type { LocalizationReport } from "../../generated/LocalizationReport";
import type { LabStudy } from "../../lab";
import { medianRange, noiseBelow } from "../../rigid-body/noise-level";
import type { RangeNoise, Scenario } from "../../scenario";
import { keyOf, type StudyPlan, type StudySubject } from "../../state/study.svelte";
import type { SweepBlock } from "../../workers/messages";
import { startSweepWorker } from "../../workers/start";
import { sweepPlots } from "./plots";
import type { LocalizeRun } from "./run";

/** Errors over a sweep of the noise: roughly at once while one drags, then finely. */

/** The averages, and where on the axis they stand, dB. */
export interface SweepAverages extends LocalizationReport {
  readonly zetas: Float64Array;
}

const LAST_DB = 100;
const FINE: StudyPlan = { perBlock: 50, firstPicture: 50, most: 1000 };
const FINE_STEP_DB = 5;
const COARSE: StudyPlan = { perBlock: 20, firstPicture: 20, most: 20 };
const COARSE_STEP_DB = 10;

/** Signal to noise ratios from 0 on, dB. */
export function zetasBy(step: number): Float64Array {
  return Float64Array.from({ length: LAST_DB / step + 1 }, (_, k) => step * k);
}

export const ZETAS = zetasBy(FINE_STEP_DB);

export const study: LabStudy<LocalizeRun, SweepAverages, Scenario> = {
  always: true,
  subject(scenario, run) {
    const range = medianRange({ ...run, anchors: scenario.anchors });
    const sketch = subjectOf(scenario, range, COARSE_STEP_DB, COARSE);
    return { ...subjectOf(scenario, range, FINE_STEP_DB, FINE), sketch };
  },
  startWorker: startSweepWorker,
  plots: ({ averages }, scenario, run) => sweepPlots(averages.zetas, averages, scenario, run),
};

function subjectOf(
  scenario: Scenario,
  range: number,
  step: number,
  plan: StudyPlan,
): StudySubject<SweepAverages, Scenario> {
  const zetas = zetasBy(step);
  const sweep = [...zetas].map((zeta): RangeNoise => noiseBelow(scenario.noise.kind, range, zeta));
  return {
    scenario,
    // Whatever the noise of the scenario itself is, the sweep is the same.
    key: keyOf({ ...scenario, noise: sweep }),
    plan,
    block: (firstTrial, trials): SweepBlock => ({ scenario, sweep, firstTrial, trials }),
    openSum() {
      const sum = new SweepSum(scenario, sweep);
      return {
        push: (block) => sum.push(block),
        read: () => ({ ...sum.read(), zetas }),
        free: () => sum.free(),
      };
    },
  };
}
