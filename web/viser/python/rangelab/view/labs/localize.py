"""One epoch localized in many trials: the timeline goes through the trials."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ...arrays import Floats
from ...scenario import Scenario
from ...studies import Study
from .. import shapes
from ..canvas import Canvas
from ..looks import LOCALIZER_BOUNDS, LOCALIZERS
from ..picture import Handle, Wish
from ..plots import Line, Plot
from ..readout import Row, Table, root_mean_square
from . import drawing
from . import localize_told as told_of
from .localize_panel import cloud_of
from .noise_sweep import LAST, coarse_sweep
from .sweep_plots import sweep_plots
from .track import anchor_handles

TIP = 1.6
"""How far the tips of the axes are from the body, beside its farthest sensor."""


@dataclass
class LocalizePicture:
    """The first epoch of some trials through the localizers."""

    wish: Wish
    run: list[dict[str, Any]]
    """The crate's `SnapshotRun` of each trial."""
    sweep: Study
    """Averages over many trials at even steps of the noise."""

    @property
    def name(self) -> str:
        """What people call it."""
        return str(self.run[0]["name"])

    @property
    def times(self) -> Floats:
        """The trials by their numbers."""
        return np.arange(len(self.run), dtype=np.float64)

    @property
    def outline(self) -> Floats:
        """Anchors and the body."""
        return np.array([*self.run[0]["anchors"], self.run[0]["truth"]["position"]])

    @property
    def magnification(self) -> float:
        """So that the largest error of a body is seen."""
        errors = list(self._errors("position").values())
        return min(10.0, drawing.magnification(errors, drawing.extent_of(self.outline), 0.2))

    @property
    def _scale(self) -> float:
        assert isinstance(self.wish.source, Scenario)
        return drawing.body_scale(self.wish.source.sensors, drawing.extent_of(self.outline), drawing.ALONE)

    def sentences(self) -> list[str]:
        """Who is nearest, who mirrors the body and who fails in how many trials, and what is drawn."""
        count, names = len(self.run), self._names()
        bounds = {each["name"]: (_number(each["angle"]), _number(each["position"])) for each in self.run[0]["bounds"]}
        rates = {name: float(np.mean(self._column(i, "reflected") == 1)) for i, name in enumerate(names)}
        failures = {name: list(filter(None, self._entries(i, "failure"))) for i, name in enumerate(names)}
        told = [
            told_of.nearest(self._errors("angle"), self._errors("position"), bounds, count),
            told_of.mirroring(rates),
            told_of.failing(failures, count),
            f"Bodies: one trial of {count} a step, dashed where mirrored; dots: positions in all trials.",
        ]
        return [*filter(None, told), *drawing.scale_sentence(self._scale)]

    def handles(self) -> list[Handle]:
        """Anchors and the body."""
        assert isinstance(self.wish.source, Scenario)
        return drawing.around_the_body(anchor_handles(self.wish.source.to_dict()))

    def plots(self) -> list[Plot]:
        """Averages noise by noise, and errors trial by trial beside the bounds."""
        degrees = float(np.degrees(1.0))
        angles, positions = self._errors("angle"), self._errors("position")
        sensors = {name: self._column(i, "sensors_error") for i, name in enumerate(self._names())}
        return [
            *sweep_plots(self.sweep, LAST, self._shown_bounds()),
            self._plot("Orientation error of each trial, deg", "angle", angles, degrees),
            self._plot("Position error of each trial, m", "position", positions, 1.0),
            self._plot("Error of all sensors in each trial, m", "sensors", sensors, 1.0),
        ]

    def readout(self, step: int) -> Table:
        """Errors of a trial, root mean squares over all of them, and the bounds."""
        rows = [self._row(i, name, step) for i, name in enumerate(self._names())]
        bounds = {bound["name"]: bound for bound in self.run[0]["bounds"]}
        for name in self._shown_bounds():
            angle, position, sensors = (_number(bounds[name][key]) for key in ("angle", "position", "sensors"))
            numbers = (np.degrees(angle), position, sensors)
            rows.append(Row(LOCALIZER_BOUNDS[name], (*numbers[:2], *numbers)))
        heads = ("orient.\ndeg", "position\nm")
        averaged = f"RMSE of {len(self.run)} trials"
        groups = (("this trial", heads), (averaged, (*heads, "sensors\nm", "mirr.\n%", "itera-\ntions")))
        return Table(groups, tuple(rows))

    def draw(self, canvas: Canvas, step: int, magnify: float) -> None:
        """The body, the estimates of one trial, the positions of all others as dots."""
        run = self.run[step]
        assert isinstance(self.wish.source, Scenario)
        truth, sensors = run["truth"], self._scale * self.wish.source.sensors
        place, turned = np.array(truth["position"]), np.array(truth["orientation"])
        corners = shapes.body(turned, place, sensors)
        canvas.lines("/truth/body", shapes.frame(sensors, corners), "truth", 3.0)
        present = np.ones((len(run["anchors"]), len(sensors)), dtype=bool)
        drawing.draw_ranges(canvas, np.array(run["anchors"]), corners, present)
        for i, each in enumerate(run["estimators"]):
            look = LOCALIZERS[each["name"]]
            cloud = shapes.magnified(self._positions(i), place, magnify)
            canvas.marks(f"/estimators/{each['name']}/cloud", shapes.lifted(cloud), look, 0.4)
            if self.wish.fans:
                self._draw_tips(canvas, i, place, float(np.linalg.norm(sensors, axis=1).max()))
            if each["pose"] is not None:
                self._draw_body(canvas, "body", each, place, sensors, magnify)
            mirrored = next((run["estimators"][i] for run in self.run if run["estimators"][i]["reflected"]), None)
            if mirrored is not None and not each["reflected"]:
                self._draw_body(canvas, "mirrored", mirrored, place, sensors, magnify)

    def _draw_body(
        self, canvas: Canvas, part: str, each: dict[str, Any], place: Floats, sensors: Floats, magnify: float
    ) -> None:
        """The estimate of a trial; dashed where it mirrors the body."""
        look, name = LOCALIZERS[each["name"]], f"/estimators/{each['name']}/{part}"
        position = shapes.magnified(np.array(each["pose"]["position"]), place, magnify)
        corners = shapes.body(np.array(each["pose"]["orientation"]), position, sensors)
        segments = shapes.frame(sensors, corners)
        if each["reflected"]:
            segments = shapes.dashed(shapes.divided(segments, 12))
        canvas.lines(name, segments, look.token, 2.0)
        canvas.marks(f"{name}-mark", shapes.lifted(position[None]), look)

    def _draw_tips(self, canvas: Canvas, index: int, place: Floats, radius: float) -> None:
        """A dot at the tip of each axis in each trial around the true position; a ring where the body is mirrored."""
        name = self._names()[index]
        for mirrored, mark, size in ((False, "disc", 0.4), (True, "ring", 0.8)):
            found = [
                np.array(each["pose"]["orientation"]).T
                for each in (run["estimators"][index] for run in self.run)
                if each["pose"] is not None and each["reflected"] == mirrored
            ]
            if found:
                tips = shapes.lifted(place + TIP * radius * np.concatenate(found))
                canvas.marks(f"/fans/{name}/{mark}", tips, replace(LOCALIZERS[name], mark=mark), size)

    def _row(self, index: int, name: str, step: int) -> Row:
        angles, positions = (self._errors(key)[name] for key in ("angle", "position"))
        failure = self.run[step]["estimators"][index]["failure"]
        mirrored = np.nanmean(self._column(index, "reflected")) if np.isfinite(angles).any() else np.nan
        iterations = self._column(index, "iterations")
        known = iterations[np.isfinite(iterations)]
        overall = (
            root_mean_square(self._column(index, "sensors_error")),
            100 * float(mirrored),
            float(known.mean()) if len(known) else np.nan,
        )
        found = (*drawing.readings(angles, positions, step), *overall)
        return Row(LOCALIZERS[name], found, "no estimate in this trial" if failure else "")

    def _names(self) -> list[str]:
        return [each["name"] for each in self.run[0]["estimators"]]

    def _entries(self, index: int, key: str) -> list[Any]:
        """What a localizer says in each trial."""
        return [run["estimators"][index][key] for run in self.run]

    def _column(self, index: int, key: str) -> Floats:
        """A number of a localizer in each trial; NaN where it gave nothing."""
        parts = [run["estimators"][index] for run in self.run]
        return np.array([np.nan if part["failure"] else part[key] for part in parts])

    def _errors(self, key: str) -> dict[str, Floats]:
        """An error of each localizer that sees a body, in each trial."""
        found = {}
        for i, name in enumerate(self._names()):
            errors = [run["estimators"][i]["errors"] for run in self.run]
            found[name] = np.array([np.nan if each is None else each[key] for each in errors])
        return found

    def _positions(self, index: int) -> Floats:
        """Of one localizer in each trial, m: T x D, NaN where it has no pose."""
        none = [np.nan] * self.run[0]["dimension"]
        poses = [run["estimators"][index]["pose"] for run in self.run]
        return np.array([none if pose is None else pose["position"] for pose in poses])

    def _plot(self, title: str, key: str, errors: dict[str, Floats], factor: float) -> Plot:
        lines = self._bounds(key, factor) + drawing.lines_of(LOCALIZERS, errors, factor)
        return Plot(title, self.times, lines, axis="trial")

    def _shown_bounds(self) -> list[str]:
        """The bounds that say something about those that run."""
        names = self._names()
        hidden = {
            "uc_crb_raw": not set(names) & set(told_of.ON_RAW_RANGES),
            "classical_crb": "classical-ls" not in names,
        }
        return [name for name in LOCALIZER_BOUNDS if not hidden.get(name)]

    def _bounds(self, key: str, factor: float) -> tuple[Line, ...]:
        """The least root mean square error over trials."""
        bounds = {bound["name"]: bound[key] for bound in self.run[0]["bounds"]}
        shown = [name for name in self._shown_bounds() if bounds.get(name) is not None]
        count = len(self.run)
        return tuple(Line(LOCALIZER_BOUNDS[name], np.full(count, factor * bounds[name]), 1.5) for name in shown)


def _number(value: float | None) -> float:
    return np.nan if value is None else value


def localize(wish: Wish) -> LocalizePicture:
    """Runs the crate.

    Raises:
        Error: in a sentence.
    """
    source = wish.source
    assert isinstance(source, Scenario)
    sweep = wish.study if isinstance(wish.study, Study) else coarse_sweep(source)
    trials = cloud_of(source.to_dict())
    return LocalizePicture(wish, [source.localize(wish.trial + trial) for trial in range(trials)], sweep)
