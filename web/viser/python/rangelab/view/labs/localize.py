"""One epoch localized in many trials: the timeline goes through the trials."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...arrays import Floats
from ...scenario import Scenario
from ...studies import Study
from .. import shapes
from ..canvas import Canvas
from ..looks import LOCALIZER_BOUNDS, LOCALIZERS
from ..panel import Panel
from ..picture import Handle, Wish
from ..plots import Line, Plot
from ..readout import Row, Table, root_mean_square
from . import drawing
from .anchors import anchor_controls
from .noise import noise_controls
from .track import anchor_handles
from .track_panel import seed_controls

TRIALS = 50
ZETAS = np.arange(0.0, 101.0, 10.0)
LOSS = "localize.loss"
LOSSES: dict[str, dict[str, Any]] = {"squared": {"kind": "squared"}, "huber": {"kind": "huber", "scale": 1.345}}
ON_RAW_RANGES = ("gauss-newton", "maximum-likelihood")


@dataclass
class LocalizePicture:
    """The first epoch of some trials through the localizers."""

    wish: Wish
    run: list[dict[str, Any]]
    """The crate's `SnapshotRun` of each trial."""
    sweep: Study
    """Averages over the trials at each of `ZETAS`."""

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
        """Who failed, and who mirrors the body in how many trials."""
        told = [f"Each step is another trial, {len(self.run)} in all; dots are the other trials."]
        for i, each in enumerate(self.run[0]["estimators"]):
            parts = [run["estimators"][i] for run in self.run]
            mirrored = sum(part["reflected"] for part in parts)
            if mirrored:
                told.append(f"{each['label']} mirrors the body in {mirrored} trials.")
            failures = [part["failure"] for part in parts if part["failure"]]
            if failures:
                told.append(f"{each['label']} gave nothing in {len(failures)} trials: {failures[0]}")
        return [*told, *drawing.scale_sentence(self._scale)]

    def handles(self) -> list[Handle]:
        """Anchors and the body."""
        assert isinstance(self.wish.source, Scenario)
        return drawing.around_the_body(anchor_handles(self.wish.source.to_dict()))

    def plots(self) -> list[Plot]:
        """Errors trial by trial beside the bounds."""
        degrees = float(np.degrees(1.0))
        angles, positions = self._errors("angle"), self._errors("position")
        sensors = {name: self._column(i, "sensors_error") for i, name in enumerate(self._names())}
        return [
            self._plot("Orientation error, deg", "angle", angles, degrees),
            self._plot("Position error, m", "position", positions, 1.0),
            self._plot("Error of all sensors, m", "sensors", sensors, 1.0),
            self._sweep("Orientation RMSE, deg", "rms_angle", "angle", degrees),
            self._sweep("Position RMSE, m", "rmse_position", "position", 1.0),
        ]

    def readout(self, step: int) -> Table:
        """Errors of a trial, root mean squares over all of them, and the bounds."""
        rows = [self._row(i, name, step) for i, name in enumerate(self._names())]
        bounds = {bound["name"]: bound for bound in self.run[0]["bounds"]}
        for name in self._shown_bounds():
            angle, position, sensors = (_number(bounds[name][key]) for key in ("angle", "position", "sensors"))
            numbers = (np.degrees(angle), position, sensors)
            rows.append(Row(LOCALIZER_BOUNDS[name], (*numbers[:2], *numbers, np.nan)))
        heads = ("orient.\ndeg", "position\nm")
        averaged = f"RMSE of {len(self.run)} trials"
        groups = (("this trial", heads), (averaged, (*heads, "sensors\nm", "mirrored\n%")))
        return Table(groups, tuple(rows))

    def draw(self, canvas: Canvas, step: int, magnify: float) -> None:
        """The body, the estimates of one trial, the positions of all others as dots."""
        run = self.run[step]
        assert isinstance(self.wish.source, Scenario)
        truth, sensors = run["truth"], self._scale * self.wish.source.sensors
        place, turned = np.array(truth["position"]), np.array(truth["orientation"])
        corners = shapes.body(turned, place, sensors)
        canvas.lines("/truth/body", shapes.pairs(shapes.lifted(corners)), "truth", 3.0)
        present = np.ones((len(run["anchors"]), len(sensors)), dtype=bool)
        drawing.draw_ranges(canvas, np.array(run["anchors"]), corners, present)
        for i, each in enumerate(run["estimators"]):
            look = LOCALIZERS[each["name"]]
            cloud = shapes.magnified(self._positions(i), place, magnify)
            canvas.marks(f"/estimators/{each['name']}/cloud", shapes.lifted(cloud), look, 0.4)
            if each["pose"] is None:
                continue
            position = shapes.magnified(np.array(each["pose"]["position"]), place, magnify)
            corners = shapes.body(np.array(each["pose"]["orientation"]), position, sensors)
            segments = shapes.pairs(shapes.lifted(corners))
            if each["reflected"]:
                segments = shapes.dashed(shapes.divided(segments, 12))
            canvas.lines(f"/estimators/{each['name']}/body", segments, look.token, 2.0)
            canvas.marks(f"/estimators/{each['name']}/mark", shapes.lifted(position[None]), look)

    def _row(self, index: int, name: str, step: int) -> Row:
        angles, positions = (self._errors(key)[name] for key in ("angle", "position"))
        failure = self.run[step]["estimators"][index]["failure"]
        mirrored = np.nanmean(self._column(index, "reflected")) if np.isfinite(angles).any() else np.nan
        overall = (root_mean_square(self._column(index, "sensors_error")), 100 * float(mirrored))
        found = (*drawing.readings(angles, positions, step), *overall)
        return Row(LOCALIZERS[name], found, "no estimate in this trial" if failure else "")

    def _names(self) -> list[str]:
        return [each["name"] for each in self.run[0]["estimators"]]

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

    def _sweep(self, title: str, figure: str, of_bound: str, factor: float) -> Plot:
        """Averages over the trials, noise by noise."""
        rows: dict[str, list[float]] = {}
        for row in self.sweep.rows():
            key = of_bound if row["name"] in LOCALIZER_BOUNDS else figure
            value = row.get(key)
            rows.setdefault(row["name"], []).append(np.nan if value is None else value)
        values = {name: np.array(each) for name, each in rows.items() if len(each) == len(ZETAS)}
        shown = self._shown_bounds()
        bounds = [Line(LOCALIZER_BOUNDS[name], factor * values[name], 1.5) for name in shown if name in values]
        localizers = {name: values[name] for name in self._names() if name in values}
        return Plot(title, ZETAS, (*bounds, *drawing.lines_of(LOCALIZERS, localizers, factor)), axis="ζ, dB")

    def _shown_bounds(self) -> list[str]:
        """The bounds that say something about those that run."""
        names = self._names()
        hidden = {"uc_crb_raw": not set(names) & set(ON_RAW_RANGES), "classical_crb": "classical-ls" not in names}
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
    assert isinstance(wish.source, Scenario)
    source = wish.source
    noises = [{"kind": "toa", "zeta_db": float(zeta)} for zeta in ZETAS]
    sweep = source.localization_study(noises, TRIALS)
    return LocalizePicture(wish, [source.localize(wish.trial + trial) for trial in range(TRIALS)], sweep)


def localize_controls(panel: Panel) -> None:
    """The controls of the page's lab Localize."""
    with panel.folder("Localizers", opened=True):
        panel.several("localize.enabled", [(name, look.label) for name, look in LOCALIZERS.items()])
    with panel.folder("Ranges", opened=True):
        noise_controls(panel)
        panel.choice("weights", "weights", (("measured", "measured"), ("true", "true")))
        seed_controls(panel)
    with panel.folder("Settings", opened=True):
        panel.choice("localize.manifold", "manifold", (("so", "SO(D)"), ("o", "O(D), the papers'")))
        losses = (("squared", "squared"), ("huber", "Huber"))
        panel.chooser(
            "loss of ML",
            losses,
            lambda found: found["localize"]["loss"]["kind"],
            lambda kind: panel.put(LOSS, LOSSES[kind]),
        )
        panel.number("localize.loss.scale", "Huber scale, standard deviations", step=0.5, least=0.0)
        panel.switch("localize.multi_start", "search again from more starts")
        panel.number("mounting_sigma", "mounting error σ_e, m", step=0.01, least=0.0)
    with panel.folder("Anchors"):
        anchor_controls(panel)
