import { localize, localizeAtNoise } from "../../engine";
import type { LocalizationReport } from "../../generated/LocalizationReport";
import type { SnapshotEstimate } from "../../generated/SnapshotEstimate";
import type { SnapshotRun } from "../../generated/SnapshotRun";
import type { LabRun } from "../../lab";
import type { PoseTrack } from "../../run";
import type { Scenario } from "../../scenario";
import { type Cloud, cloudsOf } from "./cloud";
import { CLOUD, hintOf, SHOWN } from "./view";

/** One epoch, localized in many trials; one of them is drawn. */
export interface LocalizeRun extends LabRun {
  readonly trial: number;
  readonly snapshot: SnapshotRun;
  /** The estimates of the trial drawn, as bodies: those that have a pose. */
  readonly estimates: readonly { readonly estimate: SnapshotEstimate; readonly pose: PoseTrack }[];
  readonly clouds: readonly Cloud[];
  /** Averages over the trials of the clouds, one point. */
  readonly report: LocalizationReport;
}

export function runOf(scenario: Scenario): LocalizeRun {
  const [trial, trials] = [hintOf(scenario, SHOWN), hintOf(scenario, CLOUD)];
  const snapshot = localize(scenario, trial);
  return {
    dimension: scenario.dimension,
    steps: 1,
    times: Float64Array.of(0),
    anchors: snapshot.anchors,
    truth: trackOf(snapshot.truth),
    trial,
    snapshot,
    estimates: snapshot.estimators.flatMap((estimate) =>
      estimate.pose ? [{ estimate, pose: trackOf(estimate.pose) }] : [],
    ),
    clouds: cloudsOf(scenario, trials),
    report: localizeAtNoise(scenario, trials),
  };
}

function trackOf({ orientation, position }: SnapshotRun["truth"]): PoseTrack {
  return { orientations: Float64Array.from(orientation.flat()), positions: Float64Array.from(position) };
}
