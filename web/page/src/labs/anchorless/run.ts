import {
  anchorlessCovariances,
  anchorlessOwnBounds,
  anchorlessPreset,
  anchorlessSpectrum,
  anchorlessTipCovariances,
  type KinematicsBounds,
  type KinematicsTrial,
  runAnchorless,
} from "../../engine";
import type { GramSpectrum } from "../../generated/GramSpectrum";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import type { LabRun } from "../../lab";
import type { BoundKind } from "./estimators";
import { dimensionOf, middleOf, pointsAt, seen } from "./gauge";
import { reach } from "./hints";
import { nodesOf } from "./nodes";

/** Trial 0 through the estimators, the network as the gauge shows it. */
export interface AnchorlessRun extends LabRun {
  readonly scenario: KinematicsScenario;
  readonly trial: KinematicsTrial;
  readonly spectrum: GramSpectrum;
  readonly bounds: KinematicsBounds;
  /** The bound on the covariance of each node's position at a step, m²: N x D x D; null where there is none. */
  covariances(kind: BoundKind, step: number): Float64Array | null;
  /** The same of the tips of the arrows of the l-th derivative. */
  tipCovariances(kind: BoundKind, l: number): Float64Array | null;
}

/** None but the scenario's own. */
export const OWN_STAMPS = Uint32Array.of();

export function runOf(scenario: KinematicsScenario): AnchorlessRun {
  const coefficients = seen(scenario);
  const moved = { ...scenario, coefficients };
  const trial = runAnchorless(moved, 0);
  const { times } = trial;
  const dimension = dimensionOf(scenario);
  // The engine centres every motion: the middle of the network is what that takes away.
  const middles = coefficients.map((points) => [middleOf(points)]);
  const identity = Array.from({ length: dimension * dimension }, (_, i) =>
    i % (dimension + 1) === 0 ? 1 : 0,
  );
  return {
    dimension,
    steps: times.length,
    times,
    anchors: nodesOf(scenario),
    truth: {
      positions: Float64Array.from([...times].flatMap((time) => pointsAt(middles, time)[0])),
      orientations: Float64Array.from([...times].flatMap(() => identity)),
    },
    scenario,
    trial,
    spectrum: anchorlessSpectrum(moved, 0),
    bounds: anchorlessOwnBounds(moved),
    covariances: remembered((kind, step) =>
      anchorlessCovariances(moved, kind === "accelerometers", times[step]),
    ),
    tipCovariances: remembered((kind, l) =>
      anchorlessTipCovariances(moved, kind === "accelerometers", l, reach(scenario, l)),
    ),
  };
}

type Covariances = AnchorlessRun["covariances"];

/** Every answer is kept: a scene is drawn many times at one step. Where there is no bound, the run's bounds say why. */
function remembered(compute: (...of: Parameters<Covariances>) => Float64Array): Covariances {
  const kept = new Map<string, Float64Array | null>();
  return (kind, index) => {
    const key = `${kind} ${index}`;
    const known = kept.get(key);
    if (known !== undefined) return known;
    let value: Float64Array | null = null;
    try {
      value = compute(kind, index);
    } catch {
      // As said above.
    }
    kept.set(key, value);
    return value;
  };
}

export function presetOf(name: string): KinematicsScenario {
  return anchorlessPreset(name);
}

export function nodeCount({ coefficients }: KinematicsScenario): number {
  return coefficients[0].length;
}
