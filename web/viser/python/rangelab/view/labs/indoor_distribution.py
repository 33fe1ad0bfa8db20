"""How many of the trials have an error no larger than so much: a curve a filter, over the errors of all."""

from collections.abc import Sequence

import numpy as np

from ...arrays import Floats
from ..looks import FILTERS
from ..panel import DEGREES
from ..plots import Line, Plot
from . import drawing
from .averages import Averages

MOST_PLACES = 240
"""A curve needs no more places than this."""


def distribution_plots(averages: Averages, filters: Sequence[str]) -> list[Plot]:
    """Of position and of orientation, root mean square over each trial; failed trials keep a curve below its top."""
    return [
        _plot(averages, filters, "position_distribution", 1.0, ("CDF of position, %", "position error, m")),
        _plot(averages, filters, "angle_distribution", DEGREES, ("CDF of orientation, %", "orientation error, deg")),
    ]


def shares(errors: Floats, places: Floats, trials: int) -> tuple[Floats, Floats]:
    """The share of the trials with an error no larger than each place, in per cent, and its standard error."""
    share = 100.0 * np.searchsorted(np.sort(errors), places, side="right") / trials
    return share, np.sqrt(share * (100.0 - share) / trials)


def _plot(averages: Averages, filters: Sequence[str], figure: str, factor: float, words: tuple[str, str]) -> Plot:
    found = {name: averages.summary(name) for name in filters}
    errors = {name: factor * np.array(summary[figure], dtype=np.float64) for name, summary in found.items()}
    places = _places_of(list(errors.values()))
    lines = []
    for (name, each), rim in zip(errors.items(), drawing.rims(len(errors)), strict=True):
        if not len(each):
            continue
        values, standard_errors = shares(each, places, found[name]["trials"] + found[name]["failures"])
        lines.append(Line(FILTERS[name], values, 1.5 + rim, spread=2 * standard_errors))
    return Plot(words[0], places, tuple(lines), axis=words[1], logarithmic=False, logarithmic_x=True)


def _places_of(errors: Sequence[Floats]) -> Floats:
    """At the errors themselves, all or every so many, and at the largest of each filter, where its curve ends."""
    places = np.unique(np.concatenate([*errors, np.empty(0)]))
    step = max(1, -(-len(places) // MOST_PLACES))
    ends = [each.max() for each in errors if len(each)]
    kept = (np.arange(len(places)) % step == 0) | np.isin(places, ends)
    # On a logarithmic axis there is no 0.
    return np.asarray(places[kept & (places > 0)])
