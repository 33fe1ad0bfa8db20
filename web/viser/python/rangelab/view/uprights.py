"""Upright lines in plots: uPlot has none, so each is two more points of one place, from the lowest to the highest."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import Floats
from .limits import heights, with_room
from .looks import Look

if TYPE_CHECKING:
    from .plots import Line, Plot


@dataclass(frozen=True)
class Upright:
    """What is marked along the axis."""

    x: float
    look: Look


def with_uprights(plot: "Plot") -> "Plot":
    """The plot with its uprights as lines; lines that cross them have one more point there, where they are anyway."""
    if not plot.uprights:
        return plot
    places = np.repeat([each.x for each in plot.uprights], 2)
    x = np.concatenate([plot.x, places])
    order = np.argsort(x, kind="stable")
    lines = tuple(_crossing(line, plot, places, order) for line in plot.lines)
    lowest_and_highest = heights(plot)
    limits = plot.limits if plot.logarithmic else with_room(*lowest_and_highest)
    return replace(
        plot, x=x[order], lines=(*lines, *_lines(plot, lowest_and_highest, order)), uprights=(), limits=limits
    )


def _lines(plot: "Plot", ends: tuple[float, float], order: Any) -> "list[Line]":
    lines = []
    for i, each in enumerate(plot.uprights):
        values = np.full(len(order), np.nan)
        first = len(plot.x) + 2 * i
        values[first : first + 2] = ends
        line = replace(plot.lines[0], look=each.look, values=values[order], width=1.5)
        lines.append(replace(line, dots=False, upright=True, spread=None))
    return lines


def _crossing(line: "Line", plot: "Plot", places: Floats, order: Any) -> "Line":
    """Points of a line that is dots lie at no other places."""

    def longer(values: Floats, *, logarithmic: bool) -> Floats:
        added = np.full(len(places), np.nan) if line.dots else _between(plot, places, values, logarithmic=logarithmic)
        longer_values: Floats = np.concatenate([values, added])[order]
        return longer_values

    spread = None if line.spread is None else longer(line.spread, logarithmic=False)
    return replace(line, values=longer(line.values, logarithmic=plot.logarithmic), spread=spread)


def _between(plot: "Plot", places: Floats, values: Floats, *, logarithmic: bool) -> Floats:
    """Where straight pieces of the line, as the scales show it, are at these places; NaN beyond its ends."""
    x, at = (np.log(plot.x), np.log(places)) if plot.logarithmic_x else (plot.x, places)
    y = np.log(np.where(values > 0, values, np.nan)) if logarithmic else values
    found: Floats = np.interp(at, x, y, left=np.nan, right=np.nan)
    return np.exp(found) if logarithmic else found
