"""An IMU and three transmitters on a body among beacons: filters side by side."""

from dataclasses import dataclass

import numpy as np

from ...arrays import Floats
from ...indoor import IndoorFilterRun, IndoorRun, IndoorScenario
from .. import shapes
from ..canvas import Canvas
from ..looks import FILTERS
from ..panel import DEGREES
from ..picture import Handle, Wish
from ..plots import Line, Plot
from ..readout import Row, Table
from . import drawing
from .averages import Averaged
from .indoor_averages import averaged_plots, averaged_readout
from .indoor_plots import nees_plot, stretch_plot
from .indoor_verdict import described, judged

DASHES = 48
"""A line of a missing range has half as many dashes."""


@dataclass
class IndoorPicture(Averaged):
    """A run of the filters."""

    wish: Wish
    run: IndoorRun

    @property
    def name(self) -> str:
        """What people call it."""
        return self.run.name

    @property
    def times(self) -> Floats:
        """Time at the end of each step, s: K."""
        return self.run.times

    @property
    def outline(self) -> Floats:
        """Beacons and the true track."""
        return np.concatenate([self.run.beacons, self.run.truth_positions])

    @property
    def magnification(self) -> float:
        """So that the largest error is seen and stays in the scene."""
        errors = [each.position_errors for each in self.run.filters.values()]
        return min(10.0, drawing.magnification(errors, drawing.extent_of(self.outline), 0.3))

    @property
    def body(self) -> Floats:
        """The transmitters as they are drawn, in the body frame, m: 3 x 3."""
        return self.run.transmitters * self._scale

    @property
    def _scale(self) -> float:
        return drawing.body_scale(self.run.transmitters, drawing.extent_of(self.outline))

    @property
    def _scenario(self) -> IndoorScenario:
        assert isinstance(self.wish.source, IndoorScenario)
        return self.wish.source

    def sentences(self) -> list[str]:
        """What the run or the averages teach, and how the scene is drawn."""
        convention = str(self._scenario.to_dict()["imu"]["convention"])
        if self.averages is None:
            told = described(self.run, convention)
        else:
            told = judged(self.averages, list(self.run.filters), convention)
        return [told, *drawing.scale_sentence(self._scale)]

    def handles(self) -> list[Handle]:
        """The beacons."""
        return [_beacon(m, np.array(place)) for m, place in enumerate(self._scenario.to_dict()["beacons"])]

    def plots(self) -> list[Plot]:
        """The page's plots of one run, or of the averages that there are."""
        if self.averages is not None:
            return averaged_plots(self.averages, self.times, list(self.run.filters))
        filters = self.run.filters
        angles = _lines({name: each.orientation_errors for name, each in filters.items()}, DEGREES)
        largest, least = (
            _lines({name: each.singular_values[:, at] for name, each in filters.items()}) for at in (0, 2)
        )
        return [
            Plot("Position error, m", self.times, _lines({n: each.position_errors for n, each in filters.items()})),
            Plot("Orientation error, deg", self.times, angles),
            stretch_plot("Singular values of R", self.times, largest, least),
            nees_plot("NEES / dof", self.times, _lines({name: each.nees for name, each in filters.items()})),
        ]

    def readout(self, step: int) -> Table:
        """Errors at a step with the largest singular value of R, and root mean squares over the run with its NEES."""
        if self.averages is not None:
            return averaged_readout(self.averages, step, list(self.run.filters))
        rows = tuple(self._row(name, each, step) for name, each in self.run.filters.items())
        heads = ("orient.\ndeg", "position\nm")
        return Table(((self._now(step), (*heads, "‖R‖")), ("RMSE of the run", (*heads, "NEES\n÷ dof"))), rows)

    def _now(self, step: int) -> str:
        """What is known at a step."""
        if not self.run.fixes[step]:
            return "now: IMU alone"
        present = self.run.present[step]
        return f"now: {int(present.sum())} of {present.size} ranges"

    def draw(self, canvas: Canvas, step: int, magnify: float) -> None:
        """Track and body, the ranges that were taken, estimates with their ellipsoids."""
        run, truth = self.run, self.run.truth_positions
        self._draw_ranges(canvas, step)
        drawing.draw_truth(canvas, run.truth_orientations, truth, self.body, step)
        manner = drawing.Manner(truth, self.body, magnify, self.wish.fans)
        for (name, each), rim in zip(run.filters.items(), drawing.rims(len(run.filters)), strict=True):
            drawing.draw_estimate(canvas, FILTERS[name], each, step, rim, manner)

    def _row(self, name: str, each: IndoorFilterRun, step: int) -> Row:
        found = drawing.readings(each.orientation_errors, each.position_errors, step)
        nees = each.nees[np.isfinite(each.nees)]
        mean = float(nees.mean()) if len(nees) else float("nan")
        numbers = (*found[:2], float(each.singular_values[step, 0]), *found[2:], mean)
        return Row(FILTERS[name], numbers, drawing.ended(each, step))

    def _draw_ranges(self, canvas: Canvas, step: int) -> None:
        """A line for each range of the step, dashed where it is missing; between fixes there are none."""
        if not self.run.fixes[step]:
            return
        run, present = self.run, self.run.present[step]
        ends = shapes.body(run.truth_orientations[step], run.truth_positions[step], self.body)
        drawing.draw_ranges(canvas, run.beacons, ends, present)
        missing = shapes.divided(shapes.between(run.beacons, ends, ~present), DASHES)
        canvas.lines("/ranges/missing", shapes.dashed(missing, 1, 1), "range", 1.0)


def _lines(values: dict[str, Floats], factor: float = 1.0) -> tuple[Line, ...]:
    return drawing.lines_of(FILTERS, values, factor)


def indoor(wish: Wish) -> IndoorPicture:
    """Runs the crate.

    Raises:
        Error: in a sentence.
    """
    assert isinstance(wish.source, IndoorScenario)
    return IndoorPicture(wish, wish.source.run(wish.trial))


def _beacon(m: int, place: Floats) -> Handle:
    return Handle(
        f"/anchors/{m}", f"B{m + 1}", place, lambda to, _: lambda scenario: scenario.replace({f"beacons[{m}]": to})
    )
