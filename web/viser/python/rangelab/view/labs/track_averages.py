"""The plots, the read-out and the verdict of trackers on the average over many trials."""

import numpy as np

from ...arrays import Floats
from ..limits import magnified
from ..looks import TRACK_BOUNDS, TRACKERS, Look
from ..panel import DEGREES
from ..plots import Band, Plot, expected
from ..readout import Row, Table
from .averages import Averages, without
from .consistency import consistency_bands
from .track_plots import most_degrees
from .track_verdicts import Means, verdict

FIGURES = ("rms_angle", "rmse_position")
BOUND_FIGURES = ("angle", "position")


def averaged_plots(averages: Averages, times: Floats, bounds: list[str]) -> list[Plot]:
    """Root mean square errors over time beside these bounds, projections, consistency."""
    shown = {name: TRACK_BOUNDS[name] for name in bounds}
    lines = averages.lines
    angles = lines(shown, BOUND_FIGURES[0], DEGREES) + lines(TRACKERS, FIGURES[0], DEGREES)
    positions = lines(shown, BOUND_FIGURES[1]) + lines(TRACKERS, FIGURES[1])
    projections = lines({"et-kf": TRACKERS["et-kf"]}, "event_rate", 100.0)
    # The first ranges only test the guess that one starts from.
    nis = tuple(without(line, 1) for line in lines(TRACKERS, "nis"))
    rule = (expected(times),)
    return [
        Plot("Orientation RMSE, deg", times, angles),
        Plot("Position RMSE, m", times, positions),
        Plot("Projected trials, %", times, projections, logarithmic=False),
        magnified(Plot("Mean NEES / dof", times, lines(TRACKERS, "nees") + rule, bands=_bands(averages, "nees"))),
        magnified(Plot("Mean NIS / dof, from step 2 on", times, nis + rule, bands=_bands(averages, "nis"))),
    ]


def _bands(averages: Averages, of: str) -> tuple[Band, ...]:
    """Where the means over so many trials lie if covariances are right."""
    degrees = [averages.column(name, f"{of}_degrees_of_freedom") for name in _studied(averages)]
    return consistency_bands(map(most_degrees, degrees), averages.trials)


def averaged_readout(averages: Averages, step: int, trackers: list[str], bounds: list[str]) -> Table:
    """Root mean square errors at a step with their standard errors, and NEES."""
    rows = [_row(averages, name, TRACKERS[name], FIGURES, step) for name in trackers]
    rows += [_row(averages, name, TRACK_BOUNDS[name], BOUND_FIGURES, step) for name in bounds]
    heads = ("orient.\ndeg", "position\nm")
    groups = ((f"RMSE of {averages.trials} trials", heads), ("standard error", heads), ("mean", ("NEES\n÷ dof",)))
    return Table(groups, tuple(rows), _sentence(averages))


def _sentence(averages: Averages) -> str:
    """Who stopped in how many trials, and whether filters keep what they claim."""
    names = _studied(averages)
    failures = {name: int(averages.column(name, "failures").max(initial=0)) for name in names}
    stopped = [
        f"{TRACKERS[name].label} stopped in {count} of {averages.trials} trials."
        for name, count in failures.items()
        if count
    ]
    nees = [_means(averages, name, "nees") for name in names]
    nis = [_means(averages, name, "nis", since=1) for name in names]
    return " ".join([*stopped, verdict(nees, nis)])


def _studied(averages: Averages) -> list[str]:
    return [name for name in TRACKERS if averages.has(name)]


def _means(averages: Averages, name: str, of: str, since: int = 0) -> Means:
    values = averages.curve(name, of).values
    values[:since] = np.nan
    trials = averages.trials - averages.column(name, "failures")
    return Means(TRACKERS[name].label, values, averages.column(name, f"{of}_degrees_of_freedom"), trials)


def _row(averages: Averages, name: str, look: Look, figures: tuple[str, str], step: int) -> Row:
    angle, position = averages.curve(name, figures[0], DEGREES), averages.curve(name, figures[1])
    nees = averages.curve(name, "nees").values[step] if name in TRACKERS else np.nan
    found = [getattr(curve, of)[step] for of in ("values", "standard_errors") for curve in (angle, position)]
    return Row(look, (*found, nees))
