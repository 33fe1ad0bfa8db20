"""Errors of the motion at time 0 over the number of stamps, beside their bounds: the page's study "Over K"."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ..._core import Cancelled
from ...jobs import Progress
from ...kinematics import KinematicsScenario
from ...studies import Curve, Study
from ..looks import KINEMATICS, Look
from ..panel import Document
from ..plots import Line, Plot
from ..study_page import StudyPage
from ..uprights import Upright
from . import drawing
from .anchorless_findings import judged
from .anchorless_hints import interval_of
from .anchorless_levels import Report, bound_lines

COUNTS = (10, 20, 50, 100, 200, 500, 1000)
MOST = 200
"""Trials at each number of stamps, as on the page."""
NAMES = ("Position", "Velocity", "Acceleration")
UNITS = ("m", "m/s", "m/s²")


def swept(scenario: Any, count: int = 1) -> Any:
    """The scenario with so many regular stamps and positions at one instant: the coefficients are what is compared."""
    first, last = interval_of(scenario.to_dict())
    return scenario.replace(stamps={"kind": "regular", "first": first, "last": last, "count": count}, steps=1)


def subject(scenario: Any) -> Any:
    """What the study depends on: not on how many stamps there are, nor on how it is seen."""
    return swept(scenario).to_dict() | {"view": None, "name": ""}


def over_stamps(scenario: KinematicsScenario, trials: int, progress: Progress) -> "Sweep":
    """Runs it, one number of stamps after the other.

    Raises:
        Cancelled: where progress says so before the first trials.
        Error: in a sentence.
    """
    each, studies = min(trials, MOST), list[Study]()
    for index, count in enumerate(COUNTS):

        def told(done: int, _: int, before: int = index * each) -> bool | None:
            return progress(before + done, len(COUNTS) * each)

        try:
            studies.append(swept(scenario, count).study(each, progress=told))
        except Cancelled:
            if not studies:
                raise
            break
        if studies[-1].trials < each:
            break
    return Sweep(subject(scenario), len(COUNTS) * each, tuple(studies))


@dataclass(frozen=True, eq=False)
class Sweep(StudyPage):
    """The averages at each number of stamps."""

    studies: Sequence[Study]

    subject = staticmethod(subject)

    @property
    def trials(self) -> int:
        """Trials that were run, at all numbers of stamps."""
        return sum(study.trials for study in self.studies)

    @cached_property
    def reports(self) -> list[Report]:
        """The figures at each number of stamps."""
        return [Report(study) for study in self.studies]

    def nearest(self, stamps: int) -> Report:
        """The averages at the number of stamps next to one."""
        return min(self.reports, key=lambda report: abs(np.log(report.stamps / stamps)))

    def plots(self, document: Document) -> list[Plot]:
        """Each coefficient that an estimator finds; the scenario's own number of stamps is marked."""
        summaries = [found for report in self.reports for found in report.summaries.values()]
        degree = max((len(found["coefficients"]) for found in summaries), default=1) - 1
        counts, own = np.array([float(report.stamps) for report in self.reports]), count_of_stamps(document)
        here = (Upright(float(own), Look(f"K = {own}", "anchor", dash=(7, 4))),)
        return [
            Plot(_title(order), counts, self._lines(order), "stamps K", logarithmic_x=True, uprights=here)
            for order in range(max(degree, 0) + 1)
        ]

    def sentence(self, document: Document) -> str:
        """What the sweep shows, at the number of stamps in its middle."""
        del document
        middle = self.reports[len(self.reports) // 2]
        return judged(middle, f"K = {middle.stamps}")

    def _lines(self, order: int) -> tuple[Line, ...]:
        names, kinds = self.reports[0].summaries, self.reports[0].bounds
        bounds = {kind: _at(order, [report.coefficients(kind) for report in self.reports]) for kind in kinds}
        curves = {name: Curve.of(self._found(name, order)) for name in names}
        known = bound_lines({kind: each for kind, each in bounds.items() if np.isfinite(each).any()})
        return known + drawing.banded(KINEMATICS, curves)

    def _found(self, name: str, order: int) -> list[dict[str, float | None]]:
        """What was found of a coefficient at each number of stamps; nothing where there is no such one."""
        rows = [report.summaries[name]["coefficients"] for report in self.reports]
        return [row[order] if order < len(row) else {} for row in rows]


def count_of_stamps(document: Document) -> int:
    """K of the scenario itself."""
    stamps = document["stamps"]
    return int(stamps["count"]) if stamps["kind"] == "regular" else len(stamps["times"])


def _at(order: int, rows: Sequence[Sequence[float]]) -> Any:
    """A column; NaN in rows that are too short."""
    return np.array([row[order] if order < len(row) else np.nan for row in rows], dtype=np.float64)


def _title(order: int) -> str:
    name = NAMES[order] if order < len(NAMES) else f"Y{order}"
    return f"{name} RMSE, Y{order}, {UNITS[order] if order < len(UNITS) else f'm/s^{order}'}"
