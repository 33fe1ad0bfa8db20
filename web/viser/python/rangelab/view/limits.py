"""What a plot shows upright, where its lines shall not say so themselves."""

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from .plots import Plot

CLOSE = 4.0
"""A scale is linear where the largest number is fewer times the least: a logarithmic one shows whole decades."""
ROOM = 0.05
"""Share of a linear scale that is left free above and below."""


def heights(plot: "Plot") -> tuple[float, float]:
    """The least and the largest number of lines and bands that the scale can show."""
    parts = [part for line in plot.lines for part in (line.values, *line.edges)]
    values = np.concatenate([*parts, [edge for band in plot.bands for edge in (band.low, band.high)]])
    shown = values[np.isfinite(values) & ((values > 0) | (not plot.logarithmic))]
    return (float(shown.min()), float(shown.max())) if len(shown) else (np.nan, np.nan)


def with_room(low: float, high: float) -> tuple[float, float]:
    """Limits of a linear scale."""
    room = ROOM * (high - low) or 1.0
    return low - room, high + room


def magnified(plot: "Plot") -> "Plot":
    """The plot on a linear scale of its own where its numbers are close together."""
    low, high = heights(plot)
    if not high < CLOSE * low:
        return plot
    return replace(plot, logarithmic=False, limits=with_room(low, high))
