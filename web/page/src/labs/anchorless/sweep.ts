import { AnchorlessSum, type KinematicsBounds } from "../../engine";
import type { KinematicsReport } from "../../generated/KinematicsReport";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import type { StudyPage } from "../../lab";
import { keyOf, type StudyPlan, type StudySubject } from "../../state/study.svelte";
import type { StampBlock } from "../../workers/messages";
import { startAnchorlessWorker } from "../../workers/start";
import { sweepVerdict } from "./findings";
import { intervalOf } from "./hints";
import type { AnchorlessRun } from "./run";
import type { StampAverages } from "./study";
import { sweepPlots } from "./sweep-plots";

/** The averages at each number of stamps, and the bounds on them. */
export interface SweepAverages {
  readonly trials: number;
  readonly reports: readonly KinematicsReport[];
  readonly bounds: readonly KinematicsBounds[];
}

/** The averages at the number of stamps next to one. */
export function averagesAt({ reports, bounds }: SweepAverages, stamps: number): StampAverages {
  const away = (index: number) => Math.abs(Math.log(reports[index].stamps / stamps));
  const nearest = reports.reduce((best, _, index) => (away(index) < away(best) ? index : best), 0);
  return { ...reports[nearest], bounds: bounds[nearest] };
}

const FINE_COUNTS = Uint32Array.of(10, 20, 50, 100, 200, 500, 1000);
const COARSE_COUNTS = Uint32Array.of(10, 30, 100);
const FINE: StudyPlan = { perBlock: 20, firstPicture: 20, most: 200 };
const COARSE: StudyPlan = { perBlock: 20, firstPicture: 20, most: 20 };

/** Errors of the coefficients over the number of stamps: roughly at once while one drags, then finely. */
export const sweep: StudyPage<AnchorlessRun, SweepAverages, KinematicsScenario> = {
  title: "Over K",
  always: false,
  subject: (scenario) => ({
    ...subjectOf(scenario, FINE_COUNTS, FINE),
    sketch: subjectOf(scenario, COARSE_COUNTS, COARSE),
  }),
  startWorker: startAnchorlessWorker,
  plots: ({ averages }, scenario) => sweepPlots(averages, scenario),
  told: ({ averages }) => sweepVerdict(averages),
};

/** Whatever the number of stamps of the scenario itself is, the sweep is the same. */
function subjectOf(
  scenario: KinematicsScenario,
  counts: Uint32Array,
  plan: StudyPlan,
): StudySubject<SweepAverages, KinematicsScenario> {
  const [first, last] = intervalOf(scenario);
  // Positions at one instant only: the coefficients are what is compared.
  const swept: KinematicsScenario = {
    ...scenario,
    stamps: { kind: "regular", first, last, count: 1 },
    steps: 1,
  };
  return {
    scenario,
    key: `${counts.join()} ${keyOf(swept)}`,
    plan,
    block: (firstTrial, trials): StampBlock => ({ scenario: swept, counts, firstTrial, trials }),
    openSum() {
      const sum = new AnchorlessSum(swept, counts);
      return {
        push: (block) => sum.push(block),
        read() {
          const reports = sum.read();
          return { trials: reports[0].trials, reports, bounds: sum.bounds };
        },
        free: () => sum.free(),
      };
    },
  };
}
