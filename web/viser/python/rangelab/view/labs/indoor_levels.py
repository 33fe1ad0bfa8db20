"""What each filter did over a run, or on the average over many."""

from dataclasses import dataclass

import numpy as np

from ...indoor import IndoorRun
from ..looks import FILTERS
from ..readout import root_mean_square
from .averages import Averages


@dataclass(frozen=True)
class Level:
    """One filter."""

    name: str
    position: float
    """Root mean square error, m."""
    angle: float
    """Root mean square angle, rad."""
    stretch: float
    """The largest singular value of its `R` at the end."""
    nees: float
    """Mean NEES over its degrees of freedom."""

    @property
    def label(self) -> str:
        """As it is named everywhere."""
        return FILTERS[self.name].label


def levels_of_run(run: IndoorRun) -> list[Level]:
    """Of one run; filters that stopped are left out."""
    return [
        Level(
            name,
            root_mean_square(each.position_errors),
            root_mean_square(each.orientation_errors),
            float(each.singular_values[-1, 0]),
            float(np.nanmean(each.nees)) if np.isfinite(each.nees).any() else float("nan"),
        )
        for name, each in run.filters.items()
        if each.failure is None
    ]


def levels_of_averages(averages: Averages, filters: list[str]) -> list[Level]:
    """On the average over trials; filters that reached no end are left out."""
    found = {name: averages.summary(name) for name in filters}
    return [
        Level(
            name,
            summary["position"]["value"],
            summary["angle"]["value"],
            summary["steps"][-1]["largest_singular_value"]["value"],
            summary["nees"]["value"],
        )
        for name, summary in found.items()
        if summary["trials"]
    ]
