import { DEGREES_PER_RADIAN, formatReading } from "../../controls/format";
import { bodyRadius } from "../../rigid-body/drawn";
import { centroid } from "../../rigid-body/topologies";
import type { Run } from "../../run";
import type { Scenario } from "../../scenario";

/** What a choice costs or means, in a sentence, with the numbers of the scenario. */
export interface Sentence {
  readonly text: string;
  readonly warning: boolean;
}

const told = (text: string): Sentence => ({ text, warning: false });
const warned = (text: string): Sentence => ({ text, warning: true });

export function onManifold({ estimators }: Scenario): Sentence {
  return estimators.manifold === "o"
    ? warned("Reflections fit the ranges too: a projection onto O(D) may report a mirrored body.")
    : told("Projected matrices are rotations: no mirrored bodies.");
}

export function onFeedback({ estimators }: Scenario): Sentence {
  return estimators.feedback
    ? warned(
        "KF-ortho and ET-KF go on from the projected Q while P is not told, so NEES grows. The papers do it.",
      )
    : told("The filter goes on from its own Q; the projected one is only reported.");
}

export function onMetric({ estimators }: Scenario): Sentence {
  return estimators.metric === "information"
    ? told("Badly seen entries of Q give way to well seen ones, as they always do in the UC-KF.")
    : told(
        "KF-ortho and ET-KF take the rotation nearest to Q, entry by entry; the UC-KF always weighs with P⁻¹.",
      );
}

/** The decoupled form is the joint one only where the sensors are centred. */
export function onDecoupling(scenario: Scenario): Sentence {
  if (!scenario.estimators.decoupled) return told("Q and t are solved for together, whatever the sensors.");
  const offset = Math.hypot(...centroid(scenario.sensors));
  if (offset <= 1e-9 * bodyRadius(scenario))
    return told("Exact here: the sensors are centred on the body's origin.");
  return warned(
    `The sensors' centroid lies ${formatReading(offset)} m off the body's origin: Q and t are not independent, and solving for them one after the other costs accuracy.`,
  );
}

export function onWeights({ weights }: Scenario): Sentence {
  return weights === "true"
    ? warned(
        "This is cheating, as the papers' analysis does: a real system has only the ranges that it measured.",
      )
    : told("From what was measured: all that a real system has.");
}

/** One weight an anchor is fair only while the sensors are at about the same distance from it. */
export function onWeighting(scenario: Scenario, medianRange: number): Sentence {
  if (scenario.weighting === "per_pair") return told("Each range has the variance of its own length.");
  const share = bodyRadius(scenario) / medianRange;
  const text = `All sensors take the variance of the first one's range. The body's radius is ${formatReading(100 * share)} % of the median range`;
  return share > 0.1 ? warned(`${text}, so ranges are weighted wrongly.`) : told(`${text}: little is lost.`);
}

export function onThreshold({ estimators }: Scenario): Sentence {
  return estimators.threshold.kind === "relative"
    ? warned(
        "ε √(tr P) shrinks while the filter settles: the trigger keeps acting, and events say little about the defect.",
      )
    : told("The defect ‖QᵀQ − I‖ is compared with ε itself.");
}

/** Standard deviations of the first guess, and how far off it really is. */
export function onPrior({ initial, start }: Scenario): Sentence {
  const deviation = Math.sqrt(initial.covariance);
  const angle = Math.sqrt(initial.covariance / 2) * DEGREES_PER_RADIAN;
  const size = `± ${formatReading(deviation)} m on each coordinate, ± ${formatReading(angle)}° on each angle`;
  const offset = Math.hypot(...start.position.map((value, axis) => value - initial.position[axis]));
  if (offset > 4 * deviation)
    return warned(
      `${size}; yet the body starts ${formatReading(offset)} m away. The filters will long not believe the ranges.`,
    );
  if (angle > 90)
    return warned(
      `${size}: the orientation is unknown, and the error-state filters, which linearize at the guess, may go astray.`,
    );
  return told(`${size}, at one standard deviation.`);
}

/** What the filters assume beside what really disturbs the body. */
export function onProcessNoise({ process, motion, interval }: Scenario): Sentence {
  const parts = [
    mismatch("Orientation", process.sigma_q, motion.sigma_omega * interval),
    mismatch("Position", process.sigma_t, motion.sigma_t),
  ].filter((part) => part !== null);
  return parts.length === 0 ? told("About what really disturbs the body.") : warned(parts.join(" "));
}

/**
 * Why the bound on any matrix Q can lie below that on rotations, which should be the lower one: noise on the entries of Q
 * turns the body less than noise on its angles.
 */
export function onLinearBound({ bounds }: Run, step: number): Sentence | null {
  const at = (name: string) => bounds.find((bound) => bound.name === name)?.orientation[step] ?? NaN;
  const [linear, intrinsic] = [at("linear_posterior_crb"), at("posterior_crb")];
  if (!Number.isFinite(linear) || !Number.isFinite(intrinsic)) return null;
  const sizes = [linear, intrinsic].map((angle) => formatReading(angle * DEGREES_PER_RADIAN));
  return linear < intrinsic
    ? told(
        `The linear bound, ${sizes[0]}°, lies below the intrinsic one, ${sizes[1]}°: in the linear model (12) σ_q turns the body by only σ_q/√2 about each axis.`,
      )
    : told(
        `The linear bound, ${sizes[0]}°, lies above the intrinsic one, ${sizes[1]}°: it does not know that Q is a rotation.`,
      );
}

/** What really disturbs the body, as process noise. */
export function trueProcessNoise({ motion, interval }: Scenario): Scenario["process"] {
  return { sigma_q: motion.sigma_omega * interval, sigma_t: motion.sigma_t };
}

function mismatch(what: string, assumed: number, real: number): string | null {
  if (assumed === real || (assumed > real / 2 && assumed < real * 2)) return null;
  if (assumed === 0)
    return `${what}: none assumed where there is some, so the filters stop listening to the ranges.`;
  if (real === 0) return `${what}: some assumed where there is none, so errors stop falling.`;
  return assumed < real
    ? `${what}: ${formatReading(real / assumed)} times too little, so the filters trust their prediction and lag.`
    : `${what}: ${formatReading(assumed / real)} times too much, so they trust single ranges and jitter.`;
}
