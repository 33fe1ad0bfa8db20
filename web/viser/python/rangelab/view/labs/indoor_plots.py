"""What plots of the Indoor lab have in common, of one run and of averages."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...arrays import Floats
from ..plots import Band, Line, Plot, expected
from .consistency import consistency_bands

FREEDOM = 9
"""Degrees of freedom of the NEES: orientation, position, velocity."""
ROUNDING = 1e-9
"""Singular values nearer to each other than this are one line."""
LEAST_DASH = (1, 4)


def stretch_plot(title: str, times: Floats, largest: Sequence[Line], least: Sequence[Line]) -> Plot:
    """The largest singular value of each filter's `R`, and dotted the least where it is another."""
    pairs = zip(largest, least, strict=True)
    others = [_least(below) for above, below in pairs if (np.abs(above.values - below.values) > ROUNDING).any()]
    dotted = "; dotted: the least" if others else ""
    return Plot(f"{title}{dotted}", times, (*largest, *others), logarithmic=False)


def nees_plot(title: str, times: Floats, lines: Sequence[Line], trials: int = 1) -> Plot:
    """Between the bands of chi-square if the covariances are right."""
    bands: tuple[Band, ...] = consistency_bands([FREEDOM], trials) if lines else ()
    return Plot(title, times, (*lines, expected(times)), bands=bands)


def _least(line: Line) -> Line:
    look = replace(line.look, label=f"{line.look.label}, least", dash=LEAST_DASH)
    return replace(line, look=look, width=1.5)
