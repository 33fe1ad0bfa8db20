"""What matters most about a run of trackers at a step, with the page's words and thresholds."""

from collections.abc import Callable

import numpy as np

from ...consistency import chi_squared_interval
from ...run import EstimatorRun, Run
from ..panel import DEGREES
from ..readout import reading
from ..words import joined
from .findings import Finding, first_stopped, weightiest
from .track_geometry import weak_geometry

CONSISTENT = 0.998
"""How likely a consistent filter is to be told rightly: wrongly once in a thousand steps on either side."""


def told_at(run: Run, step: int) -> str:
    """One to three sentences."""
    running = [each for each in run.estimators.values() if runs_at(each, step)]
    return weightiest(
        [
            _stopped(run, step),
            _mirrored(running, step),
            _nearest(run, running, step),
            _overconfident(running, step),
            _projected(run, step),
            weak_geometry(run, step),
            _surprised(running, step),
            _cautious(running, step),
        ]
    )


def runs_at(each: EstimatorRun, step: int) -> bool:
    """Whether it has not stopped before or at a step."""
    return each.failure is None or step < each.failure[0]


def _stopped(run: Run, step: int) -> Finding | None:
    """Estimators that gave up, with the reason of the first."""
    return first_stopped(
        (*each.failure, each.label)
        for each in run.estimators.values()
        if each.failure is not None and not runs_at(each, step)
    )


def _mirrored(running: list[EstimatorRun], step: int) -> Finding | None:
    """Estimates that no turn of the body could have made."""
    found = [each.label for each in running if np.linalg.det(each.orientations[step]) < 0]
    if not found:
        return None
    bodies = "reports a mirrored body" if len(found) == 1 else "report mirrored bodies"
    return Finding(f"{joined(found)} {bodies}: det Q < 0.", 90)


def _nearest(run: Run, running: list[EstimatorRun], step: int) -> Finding | None:
    """The estimator that was nearest so far, and how near it and its bound are now."""
    if not run.estimators:
        return Finding("No estimator is switched on.", 50)
    known = [each for each in running if np.isfinite(each.orientation_errors[: step + 1]).all()]
    if not known:
        return None
    best = min(known, key=lambda each: np.square(each.orientation_errors[: step + 1]).mean())
    bound = run.bounds.get("posterior_crb_raw" if best.name == "eskf-raw" else "posterior_crb")
    error = _errors(best.orientation_errors[step], best.position_errors[step])
    least = "" if bound is None else f"; the bound is {_errors(bound.orientation[step], bound.position[step])}"
    return Finding(f"Nearest so far: {best.label}, {error} off{least}.", 50)


def _errors(angle: float, position: float) -> str:
    return f"{reading(DEGREES * angle)}° and {reading(position)} m"


def _projected(run: Run, step: int) -> Finding | None:
    """How often the trigger of the ET-KF acted up to the step."""
    if "et-kf" not in run.estimators:
        return None
    count = int(run["et-kf"].events[: step + 1].sum())
    steps = len(run.times)
    far = f"{steps} steps" if step == steps - 1 else f"{step + 1} steps so far"
    return Finding(f"ET-KF projected at {count} of {far}.", 45 if count else 20)


def _overconfident(running: list[EstimatorRun], step: int) -> Finding | None:
    """Estimators whose errors are larger than their covariance allows."""
    found = [(each.nees[step], each) for each in running if each.nees[step] > _nees_band(each, step)[1]]
    if not found:
        return None
    largest, worst = max(found, key=lambda each: each[0])
    are = "is" if len(found) == 1 else "are"
    nees, most = _up_to(largest, found), reading(_nees_band(worst, step)[1])
    text = f"{_named(found, running, 'All')} {are} over-confident: NEES {nees}, where {most} is rarely passed."
    return Finding(text, 70)


def _surprised(running: list[EstimatorRun], step: int) -> Finding | None:
    """Estimators whose ranges come farther off than they expect; the first only test the guess one starts from."""
    if step == 0:
        return None
    found = [(each.nis[step], each) for each in running if each.nis[step] > _nis_band(each, step)[1]]
    if not found:
        return None
    largest, worst = max(found, key=lambda each: each[0])
    nis, most = _up_to(largest, found), reading(_nis_band(worst, step)[1])
    text = f"The ranges surprise {_named(found, running, 'all')}: NIS {nis}, where {most} is rarely passed."
    return Finding(text, 35)


def _cautious(running: list[EstimatorRun], step: int) -> Finding | None:
    """Estimators whose errors are smaller than they claim."""
    found = [(each.nees[step], each) for each in running if each.nees[step] < _nees_band(each, step)[0]]
    if not found:
        return None
    know, down = ("knows", "") if len(found) == 1 else ("know", "down to ")
    least = reading(min(nees for nees, _ in found))
    return Finding(f"{_named(found, running, 'All')} {know} more than claimed: NEES {down}{least}.", 15)


Found = list[tuple[float, EstimatorRun]]


def _named(found: Found, running: list[EstimatorRun], all_of: str) -> str:
    """A long list of names says no more than that it is all of them."""
    if len(found) > 2 and len(found) == len(running):
        return f"{all_of} estimators"
    return joined([each.label for _, each in found])


def _up_to(largest: float, found: Found) -> str:
    return f"{'up to ' if len(found) > 1 else ''}{reading(largest)}"


def _band_of(figure: str) -> Callable[[EstimatorRun, int], tuple[float, float]]:
    """What a figure of a consistent filter lies between."""
    return lambda each, step: _band(float(each.numbers(f"{figure}_degrees_of_freedom")[step]))


_nees_band, _nis_band = _band_of("nees"), _band_of("nis")


def _band(degrees: float) -> tuple[float, float]:
    """Everything where there are no degrees of freedom."""
    return chi_squared_interval(degrees, CONSISTENT) if degrees > 0 else (0.0, np.inf)
