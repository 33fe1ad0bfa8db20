"""Mobile nodes that measure distances between each other: their motion, and what estimators find of it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..._core import Error
from ...arrays import Floats
from ...gram_spectrum import GramSpectrum
from ...kinematics import KinematicsBound, KinematicsScenario
from ...kinematics_run import KinematicsEstimatorRun, KinematicsRun
from ...motion import RelativeKinematics
from .. import shapes
from ..canvas import Canvas
from ..looks import KINEMATICS, KINEMATICS_BOUNDS
from ..panel import Document
from ..picture import Handle, Wish
from ..plots import Line, Plot
from ..readout import Row, Table
from ..study_page import StudyPage
from ..words import number
from . import drawing
from .anchorless_averages import KinematicsAverages, averaged_readout
from .anchorless_findings import described
from .anchorless_handles import handles_of
from .anchorless_hints import ERRORS, arrow_seconds, hint_of, reach
from .anchorless_levels import bound_kinds
from .anchorless_spectrum import spectrum_plots
from .anchorless_sweep import Sweep, count_of_stamps
from .gauge import gauge_of, seen

DERIVATIVES = {1: "velocity", 2: "acceleration"}


@dataclass
class AnchorlessPicture:
    """A run of the estimators."""

    wish: Wish
    document: Document
    run: KinematicsRun
    """Of the network as the gauge shows it."""
    motion: RelativeKinematics
    """The true motion, as the gauge shows it."""
    spectrum: GramSpectrum
    bounds: dict[str, KinematicsBound | str]
    """Those for what the estimators know, by a name of `KINEMATICS_BOUNDS`; a sentence where there is none."""

    @property
    def name(self) -> str:
        """What people call it."""
        return self.run.name

    @property
    def times(self) -> Floats:
        """Instants at which the motion is played, s: T."""
        return self.run.instants

    @property
    def outline(self) -> Floats:
        """All nodes at the first, the middle and the last instant."""
        times = self.times[[0, len(self.times) // 2, -1]]
        return self.motion.positions(times).reshape(-1, self.motion.coefficients.shape[2])

    @property
    def magnification(self) -> float:
        """As the scenario says, else so that the largest error is seen."""
        errors = [each.position_errors for each in self.run.estimators.values()]
        return hint_of(self.document, ERRORS) or drawing.magnification(errors, drawing.extent_of(self.outline))

    @cached_property
    def arrow_magnification(self) -> float:
        """The same for the tips of the arrows."""
        found = [each.coefficient_errors for each in self.run.estimators.values()]
        errors = [reach(self.document, order) * each[order : order + 1] for each in found for order in DERIVATIVES]
        return hint_of(self.document, ERRORS) or drawing.magnification(errors, drawing.extent_of(self.outline))

    @property
    def arrow_seconds(self) -> float:
        """Arrows reach where the velocity alone, or the acceleration alone, would carry a node in this time."""
        return arrow_seconds(self.document)

    def sentences(self) -> list[str]:
        """What the trial or the study shows, how the network is turned, and how the scene is drawn."""
        study = self.wish.study
        bounds = {kind: self._least_errors(kind) for kind in self.bounds}
        told = study.sentence(self.document) if isinstance(study, StudyPage) else described(self.run, bounds)
        missing = [f"{self.run.missing} distances are missing."] if self.run.missing else []
        drawn = (
            f"Arrows: velocities and (dashed) accelerations at time 0, {number(self.arrow_seconds)} s of way; "
            f"errors at arrows × {number(self.arrow_magnification)}. Estimates are aligned with the truth. "
            "Ellipsoids: the bound."
        )
        return [told, *missing, *self._turned(), drawn]

    def _turned(self) -> list[str]:
        gauge = gauge_of(self.document)
        if gauge.is_identity:
            return []
        mirrored = ", mirrored," if gauge.mirrored else ""
        way = ", ".join(number(each) for each in gauge.shift)
        return [f"The gauge turns the network by {number(gauge.degrees)} degrees{mirrored} and shifts it by ({way}) m."]

    def handles(self) -> list[Handle]:
        """The nodes at time 0, and the tips of their velocities, where the gauge shows them."""
        return handles_of(self.document)

    def plots(self) -> list[Plot]:
        """The page's plots of one run, or of the study that there is."""
        if isinstance(self.wish.study, StudyPage):
            return self.wish.study.plots(self.document)
        estimators = self.run.estimators
        one = {name: each.position_errors for name, each in estimators.items() if len(each.position_errors)}
        each_time = {name: each.aligned_position_errors for name, each in estimators.items()}
        lines = drawing.lines_of(KINEMATICS, {name: values for name, values in each_time.items() if len(values)})
        _, nodes, dimension = self.motion.coefficients.shape
        return [
            self._plot("Error, one alignment, m", self._bound_lines(at_each=False) + drawing.lines_of(KINEMATICS, one)),
            self._plot("Error, aligned at each t, m", self._bound_lines(at_each=True) + lines),
            *spectrum_plots(self.spectrum, nodes, dimension, self.document["estimators"]["degree"]),
        ]

    def readout(self, step: int) -> Table:
        """Errors of the positions at a step, and of the motion at time 0, beside the bounds; or those of the study."""
        study = self.wish.study
        if isinstance(study, KinematicsAverages):
            return averaged_readout(study.report)
        if isinstance(study, Sweep):
            return averaged_readout(study.nearest(count_of_stamps(self.document)))
        rows = [_row_of(name, each, step) for name, each in self.run.estimators.items()]
        for name, bound in self.bounds.items():
            if isinstance(bound, str):
                rows.append(Row(KINEMATICS_BOUNDS[name], (), bound))
                continue
            now = float(bound.position_rmse(self.times[step])[0])
            rows.append(Row(KINEMATICS_BOUNDS[name], _padded(now, self._least_errors(name)[:3])))
        heads = ("position\nmm", "velocity\nmm/s", "accel.\nmm/s²")
        return Table(((f"t = {self.times[step]:.3g} s", ("position\nmm",)), ("errors at t = 0", heads)), tuple(rows))

    def draw(self, canvas: Canvas, step: int, magnify: float) -> None:
        """The ways of the nodes, the distances, arrows at time 0, and the estimates joined to the truth."""
        all_times = shapes.lifted(self.motion.positions(self.times))
        now = all_times[step]
        tracks = np.stack([all_times[:-1], all_times[1:]], axis=2).reshape(-1, 2, 3)
        canvas.lines("/truth/path", tracks, "truth", 1.5)
        canvas.lines("/distances", shapes.pairs(now), "range", 0.5)
        size = 0.012 * canvas.unit
        crosses = [np.stack([now - size * axis, now + size * axis], axis=1) for axis in np.eye(3)]
        canvas.lines("/truth/nodes", np.concatenate(crosses), "truth", 3.0)
        self._draw_arrows(canvas)
        self._draw_bound(canvas, step, magnify)
        for (name, each), rim in zip(self.run.estimators.items(), drawing.rims(len(self.run.estimators)), strict=True):
            errors = self._errors(each, step)
            if errors is None:
                continue
            self._draw_found_arrows(canvas, each, rim)
            look, places = KINEMATICS[name], now + magnify * shapes.lifted(errors)
            segments = np.stack([now, places], axis=1)
            known = np.isfinite(segments).all(axis=(1, 2))
            canvas.lines(f"/estimators/{name}/errors", segments[known], look.token, 1.5 + rim)
            canvas.marks(f"/estimators/{name}/marks", places[known], look, 1.0 + 0.25 * rim)

    def _draw_bound(self, canvas: Canvas, step: int, magnify: float) -> None:
        """An ellipsoid about each node: the best that any estimator could do."""
        known = [bound for bound in self.bounds.values() if not isinstance(bound, str)]
        if not known:
            return
        places = self.motion.positions(self.times[step])[0]
        nodes, dimension = places.shape
        blocks = known[-1].position_covariance(self.times[step]).reshape(nodes, dimension, nodes, dimension)
        for n, place in enumerate(places):
            canvas.ellipsoid(f"/bound/{n}", blocks[n, :, n], place, magnify, "bound")

    def _draw_arrows(self, canvas: Canvas) -> None:
        for order, (starts, tips) in self._arrows().items():
            canvas.lines(f"/arrows/{DERIVATIVES[order]}", _arrows(starts, tips, order), "anchor", 1.5)

    def _draw_found_arrows(self, canvas: Canvas, each: KinematicsEstimatorRun, rim: float) -> None:
        """The arrows as an estimator found them: their ends as much off as its errors, magnified."""
        if not len(each.coefficients):
            return
        shared = min(len(each.coefficients), len(self.run.truth))
        errors = shapes.lifted(each.coefficients[:shared] - self.run.truth[:shared])
        for order, (starts, tips) in self._arrows().items():
            if order >= shared:
                continue
            found_start = starts + self.arrow_magnification * errors[0]
            off = errors[0] + reach(self.document, order) * errors[order]
            segments = _arrows(found_start, tips + self.arrow_magnification * off, order)
            name = f"/estimators/{each.name}/{DERIVATIVES[order]}"
            canvas.lines(name, segments, KINEMATICS[each.name].token, 1.0 + rim)

    def _arrows(self) -> dict[int, tuple[Floats, Floats]]:
        """Starts and tips (N x 3, m) of the true arrows at time 0, by their order."""
        places, *derivatives = shapes.lifted(self.motion.coefficients)
        return {
            order: (places, places + reach(self.document, order) * vectors)
            for order, vectors in zip(DERIVATIVES, derivatives, strict=False)
        }

    def _least_errors(self, kind: str) -> list[float]:
        """What the bound allows of `Y_0, Y_1, ...`, m/s^l; nothing where there is none."""
        bound = self.bounds[kind]
        return [] if isinstance(bound, str) else [bound.coefficient_rmse(order) for order in range(len(self.run.truth))]

    def _errors(self, each: KinematicsEstimatorRun, step: int) -> Floats | None:
        """What an estimator is off at a step, m: N x D; None where it has no places."""
        time = self.times[step]
        if len(each.coefficients):
            found = RelativeKinematics(each.coefficients).positions(time)[0]
            return np.asarray(found - RelativeKinematics(self.run.truth).positions(time)[0])
        if not len(each.snapshots):
            return None
        nearest = int(np.abs(self.run.stamps - time).argmin())
        truth = RelativeKinematics(self.run.truth).positions(self.run.stamps[nearest])[0]
        return np.asarray(each.snapshots[nearest] - (truth - truth.mean(axis=0)))

    def _bound_lines(self, *, at_each: bool) -> tuple[Line, ...]:
        found = {name: bound for name, bound in self.bounds.items() if not isinstance(bound, str)}
        return tuple(
            Line(KINEMATICS_BOUNDS[name], bound.position_rmse(self.times, at_each=at_each), 1.5)
            for name, bound in found.items()
        )

    def _plot(self, title: str, lines: tuple[Line, ...]) -> Plot:
        return Plot(title, self.times, lines)


def anchorless(wish: Wish) -> AnchorlessPicture:
    """Runs the crate.

    Raises:
        Error: in a sentence.
    """
    assert isinstance(wish.source, KinematicsScenario)
    document = wish.source.to_dict()
    moved = wish.source if gauge_of(document).is_identity else wish.source.replace(coefficients=seen(document))
    run = moved.run(wish.trial)
    bounds = {kind: _bound(moved, kind == "accelerometers") for kind in bound_kinds(list(run.estimators))}
    return AnchorlessPicture(wish, document, run, moved.motion, moved.gram_spectrum(wish.trial), bounds)


def _arrows(starts: Floats, tips: Floats, order: int) -> Floats:
    """Segments; accelerations are dashed."""
    segments = np.stack([starts, tips], axis=1)
    return segments if order == 1 else shapes.dashed(shapes.divided(segments, 12))


def _bound(scenario: KinematicsScenario, accelerations: bool) -> KinematicsBound | str:
    """The bound, or why there is none."""
    try:
        return scenario.bound(accelerations)
    except Error as error:
        return str(error)


def _row_of(name: str, each: KinematicsEstimatorRun, step: int) -> Row:
    if not len(each.coefficient_errors):
        nothing = "finds B, no motion" if len(each.gram_errors) else "finds no motion, only each epoch"
        return Row(KINEMATICS[name], (), each.failure or nothing)
    return Row(KINEMATICS[name], _padded(float(each.position_errors[step]), each.coefficient_errors[:3].tolist()))


def _padded(now: float, at_start: list[float]) -> tuple[float, ...]:
    """Numbers of four columns in thousandths; NaN for orders that a motion does not have."""
    return tuple(1e3 * value for value in [now, *at_start, *[np.nan] * (3 - len(at_start))])
