"""What choices of the Indoor lab mean, and what they cost, in the page's words; traps begin with "Mind"."""

import numpy as np

from ..panel import Document
from ..readout import reading

TRAP = "**Mind:** "
CONVENTION = {
    "sample": "What is true at the beginning of the interval, held over it: fits no integrator exactly.",
    "disc": "What makes Euler’s rule for velocity and position exact: fits the EKF family, not the MEKF.",
    "mean": "Delta-angle and delta-velocity, as an IMU that integrates inside: fits the MEKF, not Euler’s rule.",
    "trap": "The mean of both ends: nearly fits the MEKF.",
}
RETRACTION = {
    "qr": "The Q-factor of R + V, as in the paper: first order only where all three axes turn.",
    "polar": "The nearest rotation to R + V.",
    "exponential": "R Exp ξ, ξ the turn in V: exact for a held angular velocity.",
}
TRANSPORT = {
    "none": "P stays as the Kalman filter leaves it.",
    "literal": f"{TRAP}As printed: the block of R from before the step comes back, so P₀ stays for ever.",
    "block": f"{TRAP}The block of R is turned, its cross blocks are not: P may lose definiteness.",
    "congruence": "All of P is turned with R, M P Mᵀ: stays positive definite.",
}
NO_GRAVITY = "As in the paper: the accelerometer does not feel gravity."
GRAVITY = (
    f"{TRAP}The accelerometer feels gravity: a tilt of 1° then pushes by 0.17 m/s², "
    "and a filter whose P forgets that is soon lost."
)
FEWEST_BEACONS = 4
LARGE_VARIANCE = 1e-3
TANGENT = "Only turns are uncertain, nine entries of R never apart: P₀ = σ² J Jᵀ, J how they change with a small turn."
ISOTROPIC = "P₀ = c I for all 15 entries of R, p and v, as in the paper."
ISOTROPIC_LARGE = (
    f"{TRAP}As if R could be anything near, not only a rotation: "
    "with the Q-factor this keeps a misalignment from being corrected."
)
BIAS = "No filter knows of a bias."
CENTRED = "In the body’s origin: turning does not disturb the accelerometer."
OFF_CENTRE = "Off the origin the accelerometer feels the turning, too."
PRINTED_ARM = f"{TRAP}The printed formula mixes body and world frames: it may be worse than no correction."
TRANSMITTERS = "Three, and not on a line: a line does not show its roll."
BEACONS = "A transmitter is placed by four ranges or more. Without any beacon four stand around the path."


def on_convention(document: Document) -> str:
    """What the samples of the IMU are."""
    return CONVENTION[document["imu"]["convention"]]


def on_gravity(document: Document) -> str:
    """Whether the accelerometer feels it."""
    return NO_GRAVITY if document["imu"]["gravity"] == 0 else GRAVITY


def on_ranges(document: Document) -> str:
    """Signal to noise ratio as the paper counts it, and what a fix needs."""
    beacons, sigma = len(document["beacons"]), document["ranging"]["sigma"]
    if beacons < FEWEST_BEACONS:
        who = "One beacon gives" if beacons == 1 else f"{beacons} beacons give"
        return f"{TRAP}{who} no fix: only the MEKF on ranges uses them."
    return f"{reading(float(-20 * np.log10(sigma)))} dB as the paper counts it." if sigma > 0 else ""


def on_prior(document: Document) -> str:
    """What `P_0` says."""
    prior = document["start"]["prior"]
    if prior["kind"] == "tangent":
        return TANGENT
    return ISOTROPIC_LARGE if prior["variance"] > LARGE_VARIANCE else ISOTROPIC


def on_retraction(document: Document) -> str:
    """What it makes of a step off the manifold."""
    return RETRACTION[document["filters"]["retraction"]]


def on_transport(document: Document) -> str:
    """What becomes of `P`."""
    return TRANSPORT[document["filters"]["transport"]]


def on_fixes(document: Document) -> str:
    """What the covariance of a fix knows."""
    isotropic = document["filters"]["fix_covariance"] == "isotropic"
    where = "As in the paper, wherever the beacons stand."
    return where if isotropic else "What the beacons’ places give each transmitter."


def on_lever_arm(document: Document) -> str:
    """What the place of the IMU does."""
    imu = document["imu"]
    if not any(imu["lever_arm"]):
        return CENTRED
    return PRINTED_ARM if imu["lever_arm_correction"] == "printed" else OFF_CENTRE
