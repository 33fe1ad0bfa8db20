"""Mobile nodes that measure distances between each other: their motion, and what estimators find of it."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..._core import Error
from ...arrays import Floats
from ...distances import kinematics_estimators
from ...kinematics import KinematicsBound, KinematicsScenario
from ...kinematics_run import KinematicsEstimatorRun, KinematicsRun
from ...motion import RelativeKinematics
from .. import shapes
from ..canvas import Canvas
from ..looks import KINEMATICS, KINEMATICS_BOUNDS
from ..panel import Panel
from ..picture import Change, Handle, Wish
from ..plots import Line, Plot
from ..readout import Row, Table
from . import drawing
from .choices import Chosen
from .gauge import gauge_controls
from .track_panel import seed_controls

DERIVATIVES = {1: "velocity", 2: "acceleration"}


@dataclass
class AnchorlessPicture:
    """A run of the estimators."""

    wish: Wish
    run: KinematicsRun
    motion: RelativeKinematics
    """The true motion, in the frame of the scenario."""
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
        """So that the largest error is seen."""
        errors = [each.position_errors for each in self.run.estimators.values()]
        return drawing.magnification(errors, drawing.extent_of(self.outline))

    @property
    def arrow_seconds(self) -> float:
        """Arrows reach where the velocity alone, or the acceleration alone, would carry a node in this time."""
        return 2 * float(np.ptp(self.times)) or 1.0

    def sentences(self) -> list[str]:
        """What gave nothing and why, and what is compared."""
        stopped = [f"{each.label} stopped: {each.failure}" for each in self.run.estimators.values() if each.failure]
        missing = [f"{self.run.missing} distances are missing."] if self.run.missing else []
        told = "Arrows: velocities and (dashed) accelerations at time 0. Estimates are aligned with the truth. "
        told += "Ellipsoids: the bound."
        return [*stopped, *missing, told]

    def handles(self) -> list[Handle]:
        """The nodes at time 0, and the tips of their velocities."""
        places, *derivatives = self.motion.coefficients
        nodes = [_node(n, place) for n, place in enumerate(places)]
        if not derivatives:
            return nodes
        way = self.arrow_seconds
        return [*nodes, *(_tip(n, place, place + way * derivatives[0][n], way) for n, place in enumerate(places))]

    def plots(self) -> list[Plot]:
        """The page's plots of one run."""
        estimators = self.run.estimators
        one = {name: each.position_errors for name, each in estimators.items() if len(each.position_errors)}
        each_time = {name: each.aligned_position_errors for name, each in estimators.items()}
        lines = drawing.lines_of(KINEMATICS, {name: values for name, values in each_time.items() if len(values)})
        return [
            self._plot("Error, one alignment, m", self._bound_lines(at_each=False) + drawing.lines_of(KINEMATICS, one)),
            self._plot("Error, aligned at each t, m", self._bound_lines(at_each=True) + lines),
        ]

    def readout(self, step: int) -> Table:
        """Errors of the positions at a step, and of the motion at time 0, beside the bounds."""
        rows = [_row_of(name, each, step) for name, each in self.run.estimators.items()]
        orders = range(min(3, len(self.run.truth)))
        for name, bound in self.bounds.items():
            if isinstance(bound, str):
                rows.append(Row(KINEMATICS_BOUNDS[name], (), bound))
                continue
            now = float(bound.position_rmse(self.times[step])[0])
            at_start = [bound.coefficient_rmse(order) for order in orders]
            rows.append(Row(KINEMATICS_BOUNDS[name], _padded(now, at_start)))
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
        places, *derivatives = shapes.lifted(self.motion.coefficients)
        way = self.arrow_seconds
        for order, vectors in enumerate(derivatives[:2], 1):
            tips = places + (way if order == 1 else way**2 / 2) * vectors
            segments = np.stack([places, tips], axis=1)
            if order == 2:
                segments = shapes.dashed(shapes.divided(segments, 12))
            canvas.lines(f"/arrows/{DERIVATIVES[order]}", segments, "anchor", 1.5)

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
    run = wish.source.run(wish.trial)
    senses = any(senses for name, _, senses in kinematics_estimators() if name in run.estimators)
    kinds = {"distances": False, **({"accelerometers": True} if senses else {})}
    bounds = {kind: _bound(wish.source, accelerations) for kind, accelerations in kinds.items()}
    return AnchorlessPicture(wish, run, wish.source.motion, bounds)


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


def anchorless_controls(panel: Panel) -> None:
    """The controls of the page's lab Anchorless."""
    with panel.folder("Estimators", opened=True):
        panel.several("estimators.enabled", [(name, look.label) for name, look in KINEMATICS.items()])
    with panel.folder("Noise", opened=True):
        panel.number("noise.sigma_distance", "distance σ_d, m", step=0.01, least=0.0)
        panel.number("noise.sigma_acceleration", "acceleration σ_a, m/s²", step=0.001, least=0.0)
        panel.number("noise.missing_probability", "missing distances, %", factor=100.0, step=5.0, least=0.0, most=100.0)
        seed_controls(panel)
    with panel.folder("Stamps", opened=True):
        panel.number("stamps.count", "stamps K", step=10, least=1)
        panel.number("stamps.first", "first, s", step=0.5)
        panel.number("stamps.last", "last, s", step=0.5)
        panel.number("steps", "steps played", step=10, least=1)
    with panel.folder("Assumed motion"):
        panel.number("estimators.degree", "degree L assumed", step=1, least=0, most=8)
        panel.number("estimators.range_degree", "degree q of a range", step=1, least=2, most=16)
    with panel.folder("Nodes"):
        _nodes(panel)
    with panel.folder("What distances cannot see"):
        gauge_controls(panel)


def _nodes(panel: Panel) -> None:
    chosen = Chosen(panel, "node", lambda document: [f"N{n + 1}" for n in range(len(document["coefficients"][0]))])
    for order, label in enumerate(("position, m", "velocity, m/s", "acceleration, m/s²")):
        chosen.vector(f"coefficients[{order}][#]", label, step=1.0 if order == 0 else 0.1)
    chosen.act("Remove the node", _without)
    panel.button("Add a node", lambda: panel.edit("node", _with_node))


def _with_node(scenario: Any) -> Any:
    """One more node, off the middle of the others, that moves as they do on the average."""
    coefficients = np.array(scenario.to_dict()["coefficients"])
    new = coefficients.mean(axis=1, keepdims=True)
    new[0] += 0.1 * np.ptp(coefficients[0], axis=0)
    return scenario.replace(coefficients=np.concatenate([coefficients, new.round(3)], axis=1))


def _without(index: int) -> Change:
    return lambda scenario: scenario.replace(
        coefficients=np.delete(np.array(scenario.to_dict()["coefficients"]), index, axis=1)
    )


def _node(n: int, place: Floats) -> Handle:
    return Handle(
        f"/anchors/{n}",
        f"N{n + 1}",
        place,
        lambda to, _: lambda scenario: scenario.replace({f"coefficients[0][{n}]": to}),
        size=0.7,
    )


def _tip(n: int, node: Floats, tip: Floats, way: float) -> Handle:
    return Handle(
        f"/velocities/{n}",
        "",
        tip,
        lambda to, _: lambda scenario: scenario.replace({f"coefficients[1][{n}]": (to - node) / way}),
        size=0.4,
    )
