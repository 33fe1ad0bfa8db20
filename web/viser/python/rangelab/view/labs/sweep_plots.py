"""The plots of localizers over a sweep of the noise."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...arrays import Floats
from ...studies import Curve, Study
from ..looks import LOCALIZER_BOUNDS, LOCALIZERS, Look
from ..panel import DEGREES
from ..plots import Line, Plot
from . import drawing

AXIS = "signal to noise ζ, dB"


@dataclass(frozen=True)
class Figure:
    """What a plot shows of each localizer, and of each bound where there is one."""

    title: str
    of: str
    bound: str = ""
    factor: float = 1.0
    logarithmic: bool = True
    spread: bool = True
    """Whether standard errors are a band around it."""


FIGURES = (
    Figure("Orientation RMSE, deg", "rms_angle", "angle", DEGREES),
    Figure("Position RMSE, m", "rmse_position", "position"),
    Figure("RMSE(Q)", "rmse_orientation", "orientation"),
    Figure("Mirrored bodies, %", "reflection_rate", factor=100.0, logarithmic=False),
    Figure("Bias of Q; below RMSE(Q) ÷ √trials it is chance", "bias_orientation", spread=False),
    Figure("Iterations", "iterations", logarithmic=False),
    Figure("Sensor RMSE, m", "rmse_sensors", "sensors"),
)


def sweep_plots(study: Study, last: float, bounds: list[str]) -> list[Plot]:
    """All of them, with these bounds; the points of the study are in even steps from 0 to the last, dB."""
    report = study.to_dict()
    zetas = np.linspace(0.0, last, len(report["points"]))
    points = {part["name"]: part["points"] for part in (*report["estimators"], *report["bounds"])}
    names = [part["name"] for part in report["estimators"]]
    return [_plot(figure, zetas, points, names, bounds) for figure in FIGURES]


def _plot(figure: Figure, zetas: Floats, points: dict[str, Any], names: list[str], bounds: list[str]) -> Plot:
    shown = [name for name in bounds if figure.bound and name in points]
    dashed = [_line(LOCALIZER_BOUNDS[name], points[name], figure.bound, figure, 1.5) for name in shown]
    widths = drawing.rims(len(names))
    lines = [
        _line(LOCALIZERS[name], points[name], figure.of, figure, 1.5 + rim)
        for name, rim in zip(names, widths, strict=True)
    ]
    known = tuple(line for line in (*dashed, *lines) if np.isfinite(line.values).any())
    return Plot(figure.title, zetas, known, AXIS, figure.logarithmic)


def _line(look: Look, points: list[dict[str, Any]], key: str, figure: Figure, width: float) -> Line:
    curve = Curve.of((point.get(key) or {} for point in points), figure.factor)
    return Line(look, curve.values, width, spread=2 * curve.standard_errors if figure.spread else None)
