"""The plots and the read-out of trackers on the average over many trials."""

import numpy as np

from ...arrays import Floats
from ..looks import TRACK_BOUNDS, TRACKERS, Look
from ..panel import DEGREES
from ..plots import Plot, expected
from ..readout import Row, Table
from .averages import Averages, without

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
    return [
        Plot("Orientation RMSE, deg", times, angles),
        Plot("Position RMSE, m", times, positions),
        Plot("Projected trials, %", times, projections, logarithmic=False),
        Plot("Mean NEES / dof", times, (*lines(TRACKERS, "nees"), expected(times))),
        Plot("Mean NIS / dof, from step 2 on", times, (*nis, expected(times))),
    ]


def averaged_readout(averages: Averages, step: int, trackers: list[str], bounds: list[str]) -> Table:
    """Root mean square errors at a step with their standard errors, and NEES."""
    rows = [_row(averages, name, TRACKERS[name], FIGURES, step) for name in trackers]
    rows += [_row(averages, name, TRACK_BOUNDS[name], BOUND_FIGURES, step) for name in bounds]
    heads = ("orient.\ndeg", "position\nm")
    groups = ((f"RMSE of {averages.trials} trials", heads), ("standard error", heads), ("mean", ("NEES\n÷ dof",)))
    return Table(groups, tuple(rows))


def _row(averages: Averages, name: str, look: Look, figures: tuple[str, str], step: int) -> Row:
    angle, position = averages.curve(name, figures[0], DEGREES), averages.curve(name, figures[1])
    nees = averages.curve(name, "nees").values[step] if name in TRACKERS else np.nan
    found = [getattr(curve, of)[step] for of in ("values", "standard_errors") for curve in (angle, position)]
    return Row(look, (*found, nees))
