"""Averages over many trials as lines with bands and as numbers of the read-out."""

from functools import cached_property
from typing import Any

import numpy as np

from ...arrays import Floats
from ...studies import Curve, Study
from ..looks import Look
from ..picture import Wish
from ..plots import Line
from . import drawing


class Averages:
    """The figures of a study, step by step."""

    def __init__(self, study: Study) -> None:
        self.trials = study.trials
        """How many were run."""
        self._report = study.to_dict()

    def curve(self, name: str, figure: str, factor: float = 1.0) -> Curve:
        """A figure of an estimator or bound along the steps, so many times as large."""
        return Curve.of((step.get(figure) or {} for step in self._steps[name]), factor)

    def column(self, name: str, key: str) -> Floats:
        """A plain number of an estimator at each step, such as how many trials failed."""
        return np.array([step.get(key) for step in self._steps[name]], dtype=np.float64)

    def has(self, name: str) -> bool:
        """Whether there are figures of an estimator."""
        return name in self._steps

    def summary(self, name: str) -> dict[str, Any]:
        """The figures over all steps of a filter."""
        return next(part["summary"] for part in self._report["filters"] if part["name"] == name)

    def lines(self, looks: dict[str, Look], figure: str, factor: float = 1.0) -> tuple[Line, ...]:
        """A line for each of those that have the figure, with a band of two standard errors on either side."""
        curves = {name: self.curve(name, figure, factor) for name in looks if name in self._steps}
        return drawing.banded(looks, curves)

    @cached_property
    def _steps(self) -> dict[str, list[dict[str, Any]]]:
        report = self._report
        parts = [*report.get("estimators", []), *report.get("filters", []), *report.get("bounds", [])]
        return {part["name"]: part.get("steps") or part["summary"]["steps"] for part in parts}


class Averaged:
    """A picture in which averages over many trials may stand in place of one run's errors."""

    wish: Wish

    @cached_property
    def averages(self) -> Averages | None:
        """Over many trials, where they are wished for."""
        return Averages(self.wish.study) if isinstance(self.wish.study, Study) else None


def without(line: Line, steps: int) -> Line:
    """A line from a later step on."""
    values = line.values.copy()
    values[:steps] = np.nan
    return Line(line.look, values, line.width, spread=line.spread)
