"""Plots in the panel by uPlot: lines in the estimators' colours, bounds dashed, a legend that switches lines."""

from dataclasses import dataclass

import numpy as np
import viser
from viser import uplot

from ..arrays import Floats
from .looks import Look
from .themes import Theme
from .uprights import Upright, with_uprights

HEIGHT = 230
NARROW, WIDE = 62, 88
SHADE = "26"
"""How much of its colour a band has, in hexadecimal."""
BAND_DASH = (1, 3)
"""Of the edges of a band that lines should lie in."""
HOLLOW = "rgba(0, 0, 0, 0)"
"""Of dots whose mark is a ring."""
EDGE: uplot.Series = {"label": "", "width": 0, "points": {"show": False}, "class": "mantine-hidden-from-xs"}
"""The edge of a band: not drawn, and by the class of viser's own style sheet not in the legend."""


@dataclass(frozen=True)
class Line:
    """One line."""

    look: Look
    values: Floats
    width: float = 2.0
    dots: bool = False
    """Whether it is dots where there are numbers, as large as it is wide, and no line."""
    upright: bool = False
    """Whether it has no more than two ends, which are not marked."""
    spread: Floats | None = None
    """Half the width of a band around it."""

    @property
    def edges(self) -> tuple[Floats, ...]:
        """The upper and the lower edge of the band; none where it has no width."""
        if self.spread is None or not (self.spread > 0).any():
            return ()
        return self.values + self.spread, self.values - self.spread


@dataclass(frozen=True)
class Band:
    """Where lines should lie: between two numbers, all along the axis."""

    low: float
    high: float
    label: str


@dataclass(frozen=True)
class Plot:
    """Lines over one axis; units are in the title and in the name of the axis."""

    title: str
    x: Floats
    lines: tuple[Line, ...]
    axis: str = "time, s"
    logarithmic: bool = True
    logarithmic_x: bool = False
    limits: tuple[float, float] | None = None
    """Of what is shown upright; None where the lines say so."""
    bands: tuple[Band, ...] = ()
    uprights: tuple[Upright, ...] = ()


def expected(times: Floats, value: float = 1.0) -> Line:
    """Where a line would lie if covariances were right."""
    return Line(Look("expected", "bound", dash=(2, 4)), np.full(len(times), value), 1.0)


class Plots:
    """The plots of a panel; what has the same lines as before is given new numbers only."""

    def __init__(self, server: viser.ViserServer, container: viser.GuiFolderHandle | viser.GuiTabHandle) -> None:
        self._server, self._container = server, container
        self._handles: list[viser.GuiUplotHandle] = []
        self._kinds: list[object] = []

    def draw(self, plots: list[Plot], theme: Theme) -> None:
        """Draws those that have lines, in their order."""
        plots = [with_uprights(plot) for plot in plots if plot.lines]
        kinds: list[object] = [
            (plot.title, plot.axis, _width(plot), _scales(plot), _series(plot, theme)) for plot in plots
        ]
        if kinds != self._kinds:
            for handle in self._handles:
                handle.remove()
            with self._container:
                self._handles = [self._made(plot, theme) for plot in plots]
            self._kinds = kinds
            return
        for plot, handle in zip(plots, self._handles, strict=True):
            handle.data = _data(plot)

    def _made(self, plot: Plot, theme: Theme) -> viser.GuiUplotHandle:
        return self._server.gui.add_uplot(
            _data(plot),
            _series(plot, theme),
            title=plot.title,
            bands=_bands(plot, theme),
            scales=_scales(plot),
            axes=({"label": plot.axis, "size": 28, "labelSize": 20}, {"size": _width(plot)}),
            padding=(12, 24, 0, 0),
            legend={"show": True, "live": False},
            height=HEIGHT,
        )


def _width(plot: Plot) -> int:
    """Of the numbers of the upright axis, pixels: from a million on they are longer."""
    known = np.concatenate([line.values[np.isfinite(line.values)] for line in plot.lines])
    largest = known.max(initial=0.0)
    return WIDE if largest >= 1e6 else NARROW


def _scales(plot: Plot) -> dict[str, uplot.Scale]:
    """Linear ones have number 1 with uPlot, logarithmic ones 3."""
    upright: uplot.Scale = {"distr": 3 if plot.logarithmic else 1}
    if plot.logarithmic:
        # What has no logarithm would be drawn at the bottom; at infinity it is not drawn.
        upright["clamp"] = np.inf
    if plot.limits is not None:
        upright["range"] = plot.limits
    return {"x": {"time": False, "distr": 3 if plot.logarithmic_x else 1}, "y": upright}


def _data(plot: Plot) -> tuple[Floats, ...]:
    """Lines, the edges of their bands, the edges of the plot's; on a logarithmic scale nothing is at or below 0."""
    columns = [*(line.values for line in plot.lines), *(edge for line in plot.lines for edge in line.edges)]
    columns += [np.full(len(plot.x), edge) for band in plot.bands for edge in (band.high, band.low)]
    if plot.logarithmic:
        columns = [np.where(column > 0, column, np.nan) for column in columns]
    return (plot.x, *columns)


def _series(plot: Plot, theme: Theme) -> tuple[uplot.Series, ...]:
    lines: list[uplot.Series] = []
    for line in plot.lines:
        colour = theme.css(line.look.token)
        series: uplot.Series = {"label": line.look.label, "stroke": colour, "width": line.width * theme.weight}
        if line.look.dash:
            series["dash"] = tuple(theme.weight * part for part in line.look.dash)
        if line.dots:
            fill = HOLLOW if line.look.mark == "ring" else colour
            series |= {"width": 0, "points": {"show": True, "size": 3.5 * line.width * theme.weight, "fill": fill}}
        if line.upright:
            series["points"] = {"show": False}
        lines.append(series)
    edges = sum(len(line.edges) for line in plot.lines)
    rule: uplot.Series = {"stroke": theme.css("bound"), "width": theme.weight, "dash": BAND_DASH}
    bands = [edge for band in plot.bands for edge in (rule | {"label": band.label}, EDGE | rule)]
    return ({"label": plot.axis}, *lines, *[EDGE] * edges, *bands)


def _bands(plot: Plot, theme: Theme) -> tuple[uplot.Band, ...] | None:
    """Between the edges, which come in pairs after all lines."""
    tokens = [line.look.token for line in plot.lines if line.edges] + ["bound"] * len(plot.bands)
    first = 1 + len(plot.lines)
    bands = tuple(
        uplot.Band(series=(first + 2 * i, first + 2 * i + 1), fill=theme.css(token) + SHADE)
        for i, token in enumerate(tokens)
    )
    return bands or None
