"""What a choice costs or means, in a sentence with the numbers of the scenario: those of the page, beside controls."""

import numpy as np

from ...run import Run
from ..panel import DEGREES, Document
from ..readout import reading

WARNING = "⚠ "
"""Before what is a reason to think again."""
LARGE_BODY = 0.1
"""A body is large beside the ranges where its radius is a larger share of them."""


def on_manifold(document: Document) -> str:
    """Rotations, or reflections too."""
    if document["estimators"]["manifold"] == "o":
        return f"{WARNING}Reflections fit the ranges too: a projection onto O(D) may report a mirrored body."
    return "Projected matrices are rotations: no mirrored bodies."


def on_feedback(document: Document) -> str:
    """Whether filters go on from what was projected."""
    if document["estimators"]["feedback"]:
        return (
            f"{WARNING}KF-ortho and ET-KF go on from the projected Q while P is not told, so NEES grows. "
            "The papers do it."
        )
    return "The filter goes on from its own Q; the projected one is only reported."


def on_metric(document: Document) -> str:
    """In which sense the nearest rotation is nearest."""
    if document["estimators"]["metric"] == "information":
        return "Badly seen entries of Q give way to well seen ones, as they always do in the UC-KF."
    return "KF-ortho and ET-KF take the rotation nearest to Q, entry by entry; the UC-KF always weighs with P⁻¹."


def on_decoupling(document: Document) -> str:
    """The decoupled form is the joint one only where the sensors are centred."""
    if not document["estimators"]["decoupled"]:
        return "Q and t are solved for together, whatever the sensors."
    offset = float(np.linalg.norm(np.mean(document["sensors"], axis=0)))
    if offset <= 1e-9 * _radius(document):
        return "Exact here: the sensors are centred on the body's origin."
    return (
        f"{WARNING}The sensors' centroid lies {reading(offset)} m off the body's origin: Q and t are not independent, "
        "and solving for them one after the other costs accuracy."
    )


def on_weights(document: Document) -> str:
    """Where weights of ranges come from."""
    if document["weights"] == "true":
        return (
            f"{WARNING}This is cheating, as the papers' analysis does: a real system has only the ranges that it "
            "measured."
        )
    return "From what was measured: all that a real system has."


def on_weighting(document: Document, median_range: float) -> str:
    """One weight an anchor is fair only while the sensors are at about the same distance (m) from it."""
    if document["weighting"] == "per_pair":
        return "Each range has the variance of its own length."
    share = _radius(document) / median_range
    text = (
        "All sensors take the variance of the first one's range. "
        f"The body's radius is {reading(100 * share)} % of the median range"
    )
    return f"{WARNING}{text}, so ranges are weighted wrongly." if share > LARGE_BODY else f"{text}: little is lost."


def on_threshold(document: Document) -> str:
    """What the defect is compared with."""
    threshold = document["estimators"]["threshold"]
    if threshold["kind"] == "relative":
        return (
            f"{WARNING}ε √(tr P) shrinks while the filter settles: the trigger keeps acting, and events say little "
            "about the defect."
        )
    return "The defect ‖QᵀQ − I‖ is compared with ε itself."


def on_zero_threshold(document: Document) -> str:
    """A threshold that is no line in the plot of the defect."""
    estimators = document["estimators"]
    never = estimators["threshold"]["epsilon"] != 0 or "et-kf" not in estimators["enabled"]
    return "" if never else "ε = 0: ET-KF projects at every step."


def on_guess(document: Document) -> str:
    """A guessed orientation that is none."""
    guess = np.array(document["initial"]["orientation"])
    defect = float(np.linalg.norm(guess.T @ guess - np.eye(len(guess))))
    if defect <= 1e-6:
        return ""
    return f"{WARNING}This guess is no rotation: ‖QᵀQ − I‖ = {reading(defect)}. Typing an angle makes it one."


def on_prior(document: Document) -> str:
    """Standard deviations of the first guess, and how far off it really is."""
    initial, start = document["initial"], document["start"]
    deviation = float(np.sqrt(initial["covariance"]))
    angle = DEGREES * float(np.sqrt(initial["covariance"] / 2))
    size = f"± {reading(deviation)} m on each coordinate, ± {reading(angle)}° on each angle"
    offset = float(np.linalg.norm(np.subtract(start["position"], initial["position"])))
    if offset > 4 * deviation:
        away = f"yet the body starts {reading(offset)} m away. The filters will long not believe the ranges."
        return f"{WARNING}{size}; {away}"
    if angle > 90:
        unknown = (
            "the orientation is unknown, and the error-state filters, which linearize at the guess, may go astray."
        )
        return f"{WARNING}{size}: {unknown}"
    return f"{size}, at one standard deviation."


def on_process_noise(document: Document) -> str:
    """What the filters assume beside what really disturbs the body."""
    process, motion = document["process"], document["motion"]
    turns = _mismatch("Orientation", process["sigma_q"], motion["sigma_omega"] * document["interval"])
    shifts = _mismatch("Position", process["sigma_t"], motion["sigma_t"])
    parts = " ".join(filter(None, [turns, shifts]))
    return f"{WARNING}{parts}" if parts else "About what really disturbs the body."


def on_linear_bound(run: Run) -> str:
    """Why the bound on any matrix Q can lie below that on rotations, at the end of a run.

    That one should be the lower one: noise on the entries of Q turns the body less than noise on its angles.
    """
    if not {"linear_posterior_crb", "posterior_crb"} <= run.bounds.keys():
        return ""
    linear, intrinsic = (run.bounds[name].orientation[-1] for name in ("linear_posterior_crb", "posterior_crb"))
    if not np.isfinite([linear, intrinsic]).all():
        return ""
    sizes = [reading(DEGREES * angle) for angle in (linear, intrinsic)]
    if linear < intrinsic:
        return (
            f"At the end the linear bound, {sizes[0]}°, lies below the intrinsic one, {sizes[1]}°: in the linear model "
            "(12) σ_q turns the body by only σ_q/√2 about each axis."
        )
    return (
        f"At the end the linear bound, {sizes[0]}°, lies above the intrinsic one, {sizes[1]}°: it does not know that Q "
        "is a rotation."
    )


def _radius(document: Document) -> float:
    """Distance of the farthest sensor from the body's origin, m."""
    return float(np.linalg.norm(document["sensors"], axis=1).max())


def _mismatch(what: str, assumed: float, real: float) -> str:
    if assumed == real or real / 2 < assumed < 2 * real:
        return ""
    if assumed == 0:
        return f"{what}: none assumed where there is some, so the filters stop listening to the ranges."
    if real == 0:
        return f"{what}: some assumed where there is none, so errors stop falling."
    if assumed < real:
        times = reading(real / assumed)
        return f"{what}: {times} times too little, so the filters trust their prediction and lag."
    return f"{what}: {reading(assumed / real)} times too much, so they trust single ranges and jitter."
