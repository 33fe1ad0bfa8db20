"""The plots: errors of each tracker on a logarithmic scale, their bounds dashed."""

from collections.abc import Callable

import numpy as np
import viser
from viser import uplot

from ..arrays import Floats
from ..run import BoundRun, EstimatorRun, Run
from .colours import BOUNDS, LIGHT


class Plot:
    """One plot in a panel."""

    def __init__(
        self,
        server: viser.ViserServer,
        folder: viser.GuiFolderHandle,
        title: str,
        of: Callable[[EstimatorRun], Floats],
        bound: Callable[[BoundRun], Floats] | None,
        logarithmic: bool = True,
    ) -> None:
        self._server, self._folder = server, folder
        self._title, self._of, self._bound = title, of, bound
        self._logarithmic = logarithmic
        self._handle: viser.GuiUplotHandle | None = None
        self._series: tuple[uplot.Series, ...] = ()

    def draw(self, run: Run) -> None:
        """Draws a run; where it has other trackers the plot is made anew."""
        lines = self._lines(run)
        series: tuple[uplot.Series, ...] = ({"label": "s"}, *(look for look, _ in lines))
        data = (run.times, *(values for _, values in lines))
        if self._handle is not None and series == self._series:
            self._handle.data = data
            return
        if self._handle is not None:
            self._handle.remove()
        self._series = series
        with self._folder:
            self._handle = self._server.gui.add_uplot(
                data,
                series,
                title=self._title,
                scales={"x": {"time": False}, "y": {"distr": 3 if self._logarithmic else 1}},
                axes=({"label": "time, s", "size": 28, "labelSize": 20}, {"size": 62}),
                padding=(12, 24, 0, 0),
                legend={"show": True, "live": False},
                height=220,
            )

    def _lines(self, run: Run) -> list[tuple[uplot.Series, Floats]]:
        lines: list[tuple[uplot.Series, Floats]] = []
        if self._bound is not None:
            for name, (label, dash) in BOUNDS.items():
                if name in run.bounds and (name != "posterior_crb_raw" or "eskf-raw" in run.estimators):
                    look: uplot.Series = {"label": label, "stroke": LIGHT["bound"], "width": 1.5, "dash": dash}
                    lines.append((look, self._shown(self._bound(run.bounds[name]))))
        for name, each in run.estimators.items():
            lines.append(({"label": each.label, "stroke": LIGHT[name], "width": 2}, self._shown(self._of(each))))
        return lines

    def _shown(self, values: Floats) -> Floats:
        """On a logarithmic scale nothing is at or below 0."""
        return np.where(values > 0, values, np.nan) if self._logarithmic else values


def plots(server: viser.ViserServer, folder: viser.GuiFolderHandle) -> list[Plot]:
    """The page's plots of one run."""
    return [
        Plot(
            server,
            folder,
            "Orientation error, deg",
            lambda each: np.degrees(each.orientation_errors),
            lambda bound: np.degrees(bound.orientation),
        ),
        Plot(server, folder, "Position error, m", lambda each: each.position_errors, lambda bound: bound.position),
        Plot(server, folder, "NEES over its degrees of freedom", _nees, None),
    ]


def _nees(each: EstimatorRun) -> Floats:
    return np.asarray(each.nees / each.numbers("nees_degrees_of_freedom"))
