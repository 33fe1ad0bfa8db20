"""Averages over many trials of a network, at its own stamps."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ...jobs import Progress
from ...kinematics import KinematicsScenario
from ..looks import KINEMATICS, KINEMATICS_BOUNDS
from ..panel import Document
from ..plots import Plot
from ..readout import Row, Table
from ..study_page import PageOfStudy
from .anchorless_findings import judged
from .anchorless_levels import Level, Report

HEADS = ("position\nmm", "velocity\nmm/s", "accel.\nmm/s²")


def subject(scenario: Any) -> Any:
    """What averages depend on: whatever the gauge is, they are the same, for distances do not see it."""
    return scenario.to_dict() | {"view": None, "name": ""}


def averages(scenario: KinematicsScenario, trials: int, progress: Progress) -> "KinematicsAverages":
    """Runs them.

    Raises:
        Cancelled: where progress says so before the first trials.
        Error: in a sentence.
    """
    study = scenario.study(trials, progress=progress)
    return KinematicsAverages(subject(scenario), study.asked, study)


@dataclass(frozen=True, eq=False)
class KinematicsAverages(PageOfStudy):
    """The positions over time, and the motion at time 0."""

    subject = staticmethod(subject)

    @cached_property
    def report(self) -> Report:
        """The figures."""
        return Report(self.study)

    def plots(self, document: Document) -> list[Plot]:
        """The page's plots of one run as averages, beside their bounds."""
        del document
        return [
            Plot("RMSE, one alignment, m", self.report.instants, self.report.lines("positions")),
            Plot("RMSE, aligned at each t, m", self.report.instants, self.report.lines("aligned_positions")),
        ]

    def sentence(self, document: Document) -> str:
        """What the averages show."""
        del document
        return judged(self.report, f"{self.report.stamps} stamps")


def averaged_readout(report: Report) -> Table:
    """Root mean square errors at time 0, and how many times its bound that of the velocities is, and how sure."""
    levels = {each.name: each for each in report.levels}
    rows = [_row(name, levels.get(name), found, report.trials) for name, found in report.summaries.items()]
    for kind, found in report.bounds.items():
        errors, look = report.coefficients(kind), KINEMATICS_BOUNDS[kind]
        rows.append(Row(look, (*_milli(errors), 1.0, 0.0)) if errors else Row(look, (), found["failure"] or ""))
    title = f"{report.trials} trials, K = {report.stamps}, t = 0"
    return Table(((title, HEADS), ("velocity", ("÷ CRB", "±"))), tuple(rows))


def _row(name: str, level: Level | None, summary: dict[str, Any], trials: int) -> Row:
    if level is None:
        failures = summary["failures"]
        return Row(KINEMATICS[name], (), f"nothing in {failures} of {trials} trials" if failures else "finds no motion")
    return Row(KINEMATICS[name], (*_milli(level.errors), *_over_bound(level)))


def _over_bound(level: Level) -> tuple[float, float]:
    """How many times its bound the error of the velocities is, and the standard error of that; NaN where unknown."""
    ratio = level.over_bound(1)
    if ratio is None or level.standard_errors is None:
        return np.nan, np.nan
    return ratio, ratio * level.standard_errors[1] / level.errors[1]


def _milli(values: Sequence[float]) -> list[float]:
    """The first three in thousandths; NaN for those that there are not."""
    shown = [1e3 * value for value in values[: len(HEADS)]]
    return [*shown, *[np.nan] * (len(HEADS) - len(shown))]
