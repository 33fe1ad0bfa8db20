import {
  anchorlessBounds,
  anchorlessCovariances,
  anchorlessPreset,
  anchorlessSpectrum,
  type KinematicsBounds,
  type KinematicsTrial,
  runAnchorless,
} from "../../engine";
import type { GramSpectrum } from "../../generated/GramSpectrum";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import type { LabRun } from "../../lab";
import type { BoundKind } from "./estimators";
import { nodesOf } from "./family";
import { dimensionOf, middleOf, pointsAt, seen } from "./gauge";

/** Trial 0 through the estimators, the network as the gauge shows it. */
export interface AnchorlessRun extends LabRun {
  readonly scenario: KinematicsScenario;
  readonly trial: KinematicsTrial;
  readonly spectrum: GramSpectrum;
  /** Of the coefficients alone: a curve over time takes longer than a drag waits. */
  readonly bounds: KinematicsBounds;
  /** The bound on the covariance of each node's position at a step, m²: N x D x D; null where there is none. */
  covariances(kind: BoundKind, step: number): Float64Array | null;
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
    bounds: anchorlessBounds({ ...moved, steps: 1 }, OWN_STAMPS)[0],
    covariances: remembered((kind, step) => {
      try {
        return anchorlessCovariances(moved, kind === "accelerometers", times[step]);
      } catch {
        // No bound: the run's bounds say why.
        return null;
      }
    }),
  };
}

/** The last answer of each kind is kept: a scene is drawn many times at one step. */
function remembered(compute: AnchorlessRun["covariances"]): AnchorlessRun["covariances"] {
  const kept = new Map<BoundKind, { step: number; value: Float64Array | null }>();
  return (kind, step) => {
    const known = kept.get(kind);
    if (known?.step === step) return known.value;
    const value = compute(kind, step);
    kept.set(kind, { step, value });
    return value;
  };
}

export function presetOf(name: string): KinematicsScenario {
  return anchorlessPreset(name);
}

export function nodeCount({ coefficients }: KinematicsScenario): number {
  return coefficients[0].length;
}
