"""The plots and the read-out of indoor filters on the average over many trials."""

import numpy as np

from ...arrays import Floats
from ..looks import FILTERS
from ..panel import DEGREES
from ..plots import Plot
from ..readout import Row, Table
from .averages import Averages
from .indoor_distribution import distribution_plots
from .indoor_plots import nees_plot, stretch_plot

HEADS = ("orient.\ndeg", "position\nm")


def averaged_plots(averages: Averages, times: Floats, filters: list[str]) -> list[Plot]:
    """The plots of one run as averages over trials, and how the errors of the trials are distributed."""
    ended = [name for name in filters if averages.summary(name)["trials"]]
    looks = {name: FILTERS[name] for name in ended}
    lines = averages.lines
    largest, least = (lines(looks, f"{which}_singular_value") for which in ("largest", "smallest"))
    return [
        Plot("Position RMSE, m", times, lines(looks, "position")),
        Plot("Orientation RMSE, deg", times, lines(looks, "angle", DEGREES)),
        *distribution_plots(averages, filters),
        stretch_plot("Mean singular values of R", times, largest, least),
        nees_plot("Mean NEES / dof", times, lines(looks, "nees"), averages.trials),
    ]


def averaged_readout(averages: Averages, step: int, filters: list[str]) -> Table:
    """Root mean square errors at a step, and over the run."""
    rows = tuple(_row(averages, name, step) for name in filters)
    over_all = f"RMSE, {averages.trials} trials"
    return Table((("at this step", (*HEADS, "‖R‖")), (over_all, (*HEADS, "NEES\n÷ dof"))), rows)


def _row(averages: Averages, name: str, step: int) -> Row:
    summary = averages.summary(name)
    if not summary["trials"]:
        return Row(FILTERS[name], (), f"stopped in {summary['failures']} of {averages.trials} trials")
    now = [averages.curve(name, figure).values[step] for figure in ("angle", "position", "largest_singular_value")]
    over_all = [summary[figure]["value"] for figure in ("angle", "position", "nees")]
    return Row(FILTERS[name], tuple(np.array([*now, *over_all]) * [DEGREES, 1, 1, DEGREES, 1, 1]))
