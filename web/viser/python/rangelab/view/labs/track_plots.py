"""The page's plots of one run of trackers: errors beside their bounds, the defect, consistency with its bands."""

from typing import Any

import numpy as np

from ...arrays import Floats
from ...run import EstimatorRun, Run
from ..looks import TRACK_BOUNDS, TRACKERS, Look
from ..panel import DEGREES
from ..plots import Line, Plot, expected
from ..words import number
from . import drawing
from .consistency import consistency_bands

ROUNDING = 1e-9
"""Estimators on the rotations have no defect: a line of rounding errors would only stretch the axis."""


def shown_bounds(run: Run) -> list[str]:
    """The bounds that say something about those that run."""
    names = [name for name in TRACK_BOUNDS if name in run.bounds]
    return [name for name in names if name != "posterior_crb_raw" or "eskf-raw" in run.estimators]


def plots_of(run: Run, document: dict[str, Any]) -> list[Plot]:
    """All of them; the document of a recording is empty."""
    trackers, times, lines = run.estimators, run.times, drawing.lines_of
    angles = lines(TRACKERS, {name: each.orientation_errors for name, each in trackers.items()}, DEGREES)
    positions = lines(TRACKERS, {name: each.position_errors for name, each in trackers.items()})
    return [
        Plot("Orientation error, deg", times, _bounds(run, "orientation", DEGREES) + angles),
        Plot("Position error, m", times, _bounds(run, "position") + positions),
        Plot("Defect ‖QᵀQ − I‖", times, _defects(run, document)),
        _consistency("NEES / dof", "nees", run),
        _consistency("NIS / dof, from step 2 on", "nis", run, since=1),
    ]


def _bounds(run: Run, of: str, factor: float = 1.0) -> tuple[Line, ...]:
    values = {name: factor * getattr(run.bounds[name], of) for name in shown_bounds(run)}
    return tuple(Line(TRACK_BOUNDS[name], each, 1.5) for name, each in values.items())


def _defects(run: Run, document: dict[str, Any]) -> tuple[Line, ...]:
    """With the threshold of the ET-KF and where it projected."""
    defects = {name: each.defects for name, each in run.estimators.items() if (each.defects > ROUNDING).any()}
    lines = drawing.lines_of(TRACKERS, defects)
    if "et-kf" not in defects:
        return lines
    values = np.where(run["et-kf"].events, defects["et-kf"], np.nan)
    projected = Line(Look("ET-KF projected", "et-kf", "diamond"), values, dots=True)
    return (*lines, projected, *_threshold(run, document))


def _threshold(run: Run, document: dict[str, Any]) -> tuple[Line, ...]:
    """One that moves with what the filter claims, or is at 0, is no line."""
    threshold: dict[str, Any] = document["estimators"]["threshold"] if document else {"kind": "unknown"}
    if threshold["kind"] != "absolute" or threshold["epsilon"] == 0:
        return ()
    level = np.full(len(run.times), threshold["epsilon"])
    return (Line(Look(f"ε = {number(threshold['epsilon'])}", "et-kf", dash=(2, 4)), level, 1.5),)


def _consistency(title: str, of: str, run: Run, since: int = 0) -> Plot:
    """With bands for those that have lines; the first ranges only test the guess that one starts from."""
    found = {name: _share(each, of) for name, each in run.estimators.items()}
    for each in found.values():
        each[:since] = np.nan
    lines = drawing.lines_of(TRACKERS, found)
    if not lines:
        return Plot(title, run.times, ())
    bands = consistency_bands(
        most_degrees(each.numbers(f"{of}_degrees_of_freedom")) for each in run.estimators.values()
    )
    return Plot(title, run.times, (*lines, expected(run.times)), bands=bands)


def most_degrees(degrees: Floats) -> float:
    """Missing ranges lower the degrees of freedom: the band is that of the steps that miss none."""
    return float(np.nanmax(degrees, initial=0.0))


def _share(each: EstimatorRun, of: str) -> Floats:
    """Over its degrees of freedom, so that estimators with different ones can be compared."""
    freedom = each.numbers(f"{of}_degrees_of_freedom")
    numbers = each.numbers(of)
    return np.divide(numbers, freedom, out=np.full_like(numbers, np.nan), where=freedom > 0)
