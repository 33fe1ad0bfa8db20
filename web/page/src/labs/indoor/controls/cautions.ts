import { formatReading } from "../../../controls/format";
import type { Convention } from "../../../generated/Convention";
import type { IndoorPath } from "../../../generated/IndoorPath";
import type { Retraction } from "../../../generated/Retraction";
import type { StartPrior } from "../../../generated/StartPrior";
import type { Transport } from "../../../generated/Transport";

/** What choices mean, and what they cost; `warning` where it is a trap. */
interface Caution {
  readonly text: string;
  readonly warning: boolean;
}

export const PATHS: readonly { value: IndoorPath; label: string }[] = [
  { value: "u", label: "a turn back (U)" },
  { value: "zigzag", label: "a zigzag" },
  { value: "bridge", label: "over a bridge" },
  { value: "stair", label: "up a staircase" },
  { value: "static", label: "at rest" },
  { value: "tumble", label: "tumbling" },
];

export const CONVENTIONS: readonly { value: Convention; label: string }[] = [
  { value: "sample", label: "sample" },
  { value: "disc", label: "disc" },
  { value: "mean", label: "mean" },
  { value: "trap", label: "trap" },
];

const ON_CONVENTION: Record<Convention, string> = {
  sample: "What is true at the beginning of the interval, held over it: fits no integrator exactly.",
  disc: "What makes Euler’s rule for velocity and position exact: fits the EKF family, not the MEKF.",
  mean: "Delta-angle and delta-velocity, as an IMU that integrates inside: fits the MEKF, not Euler’s rule.",
  trap: "The mean of both ends: nearly fits the MEKF.",
};

export function onConvention(convention: Convention): string {
  return ON_CONVENTION[convention];
}

export function onGravity(gravity: number): Caution {
  if (gravity === 0)
    return { text: "As in the paper: the accelerometer does not feel gravity.", warning: false };
  return {
    text: "The accelerometer feels gravity: a tilt of 1° then pushes by 0.17 m/s², and a filter whose P forgets that is soon lost.",
    warning: true,
  };
}

/** Signal to noise ratio as the paper counts it, and what a fix needs. */
export function onRanges(sigma: number, beacons: number): Caution {
  if (beacons < 4)
    return {
      text: `${beacons === 1 ? "One beacon gives" : `${beacons} beacons give`} no fix: only the MEKF on ranges uses them.`,
      warning: true,
    };
  return { text: `${formatReading(-20 * Math.log10(sigma))} dB as the paper counts it.`, warning: false };
}

export function onPrior(prior: StartPrior): Caution {
  if (prior.kind === "tangent")
    return {
      text: "Only turns are uncertain, nine entries of R never apart: P₀ = σ² J Jᵀ, J how they change with a small turn.",
      warning: false,
    };
  const large = prior.variance > 1e-3;
  return {
    text: large
      ? "As if R could be anything near, not only a rotation: with the Q-factor this keeps a misalignment from being corrected."
      : "P₀ = c I for all 15 entries of R, p and v, as in the paper.",
    warning: large,
  };
}

const ON_TRANSPORT: Record<Transport, Caution> = {
  none: { text: "P stays as the Kalman filter leaves it.", warning: false },
  literal: {
    text: "As printed: the block of R from before the step comes back, so P₀ stays for ever.",
    warning: true,
  },
  block: {
    text: "The block of R is turned, its cross blocks are not: P may lose definiteness.",
    warning: true,
  },
  congruence: { text: "All of P is turned with R, M P Mᵀ: stays positive definite.", warning: false },
};

export function onTransport(transport: Transport): Caution {
  return ON_TRANSPORT[transport];
}

const ON_RETRACTION: Record<Retraction, string> = {
  qr: "The Q-factor of R + V, as in the paper: first order only where all three axes turn.",
  polar: "The nearest rotation to R + V.",
  exponential: "R Exp ξ, ξ the turn in V: exact for a held angular velocity.",
};

export function onRetraction(retraction: Retraction): string {
  return ON_RETRACTION[retraction];
}
