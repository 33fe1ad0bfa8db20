"""What the projections of the ET-KF buy, over all thresholds: the page's study "ET budget"."""

from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import numpy as np

from ...arrays import Floats
from ...jobs import Progress
from ...scenario import Scenario
from ...studies import Curve
from ..looks import Look
from ..panel import DEGREES
from ..plots import Line, Plot
from ..readout import reading
from ..study_page import PageOfStudy
from ..uprights import Upright
from ..words import number

PAPER = 0.15
"""The paper's threshold ([T] Sec. V)."""
THRESHOLDS = PAPER * 2 ** ((np.arange(21) - 12) / 3)
"""Thirds of a factor of two to either side of the paper's."""
RELATIVE = 10.0
"""So many times as large is a threshold that is relative to what the filter claims."""
PARTS = {
    "first": Look("step 1, dotted", "et-kf", dash=(2, 4)),
    "all": Look("all steps", "et-kf"),
    "last": Look("last, dashed", "et-kf", dash=(7, 4)),
}
SAME = 0.01
"""Angles that differ by a smaller share are said to be the same."""


def subject(scenario: Any) -> Any:
    """What the study depends on: all thresholds are studied, whichever is chosen, and no other estimator."""
    document = scenario.to_dict()
    estimators = document.get("estimators", {})
    threshold = {"kind": estimators.get("threshold", {}).get("kind")}
    return document | {"estimators": estimators | {"enabled": [], "threshold": threshold}}


def budget(scenario: Scenario, trials: int, progress: Progress) -> "Budget":
    """Runs it.

    Raises:
        Cancelled: where progress says so before the first trials.
        Error: in a sentence.
    """
    relative = scenario.to_dict()["estimators"]["threshold"]["kind"] == "relative"
    thresholds = THRESHOLDS * (RELATIVE if relative else 1.0)
    study = scenario.budget_study(thresholds, trials, progress=progress)
    return Budget(subject(scenario), study.asked, study)


@dataclass(frozen=True, eq=False)
class Budget(PageOfStudy):
    """Projections in a run and errors at each threshold."""

    subject = staticmethod(subject)

    def plots(self, document: dict[str, Any]) -> list[Plot]:
        """Errors over projections spent, and both over the threshold."""
        spent = self.curve("projections")
        order = np.lexsort((-self.thresholds, spent.values))
        by_spending = partial(Plot, axis="projections in a run", uprights=self._marks(document, self.spent_at))
        by_threshold = partial(Plot, axis="threshold ε", logarithmic_x=True, uprights=self._marks(document, float))
        look = Look("projections", "et-kf", "diamond")
        projections = Line(look, spent.values, spread=2 * spent.standard_errors)
        x = spent.values[order]
        return [
            by_spending("Error of Q by projections", x, self._lines("orientation", order=order)),
            by_spending("Angle by projections, deg", x, self._lines("angle", DEGREES, order)),
            by_threshold("Error of Q by threshold", self.thresholds, self._lines("orientation")),
            by_threshold("Projections in a run", self.thresholds, (projections,), logarithmic=False),
        ]

    def sentence(self, document: dict[str, Any]) -> str:
        """What the projections at the chosen threshold buy, against as good as none."""
        epsilon = document["estimators"]["threshold"]["epsilon"]
        first, last = (self.curve("orientation", part) for part in ("first", "last"))
        angle = self.curve("angle", "first").values
        same = abs(self._at(epsilon, angle) / angle[-1] - 1) < SAME
        return (
            f"ε = {number(epsilon)}: {reading(self.spent_at(epsilon))} projections a run. "
            f"RMSE of Q at step 1: {reading(self._at(epsilon, first.values))}, "
            f"without any {reading(first.values[-1])}; at the last {reading(self._at(epsilon, last.values))}."
            f"{' The angle gains nothing.' if same else ''} {self.trials} trials."
        )

    def curve(self, *keys: str) -> Curve:
        """A figure of the study at each threshold."""
        rows = self._rows
        for key in keys:
            rows = [row[key] for row in rows]
        return Curve.of(rows)

    @cached_property
    def thresholds(self) -> Floats:
        """Those that were studied, increasing."""
        return np.array([row["epsilon"] for row in self._rows])

    def spent_at(self, epsilon: float) -> float:
        """Projections in a run at a threshold."""
        return self._at(epsilon, self.curve("projections").values)

    def _at(self, epsilon: float, values: Floats) -> float:
        """Between the thresholds over their logarithms; beyond their ends as it is there."""
        return float(np.interp(np.log(max(epsilon, self.thresholds[0])), np.log(self.thresholds), values))

    def _lines(self, of: str, factor: float = 1.0, order: Any = slice(None)) -> tuple[Line, ...]:
        curves = {part: self.curve(of, part) for part in PARTS}
        return tuple(
            Line(PARTS[part], factor * curve.values[order], spread=2 * factor * curve.standard_errors[order])
            for part, curve in curves.items()
        )

    def _marks(self, document: dict[str, Any], place_of: Any) -> tuple[Upright, ...]:
        """The chosen threshold and the paper's, which knows none that moves with what the filter claims."""
        threshold = document["estimators"]["threshold"]
        chosen = max(threshold["epsilon"], self.thresholds[0])
        marks = [Upright(place_of(chosen), Look(f"ε = {number(threshold['epsilon'])}", "et-kf"))]
        if threshold["kind"] == "absolute":
            marks.append(Upright(place_of(PAPER), Look(f"paper: {number(PAPER)}", "bound", dash=(7, 4))))
        return tuple(marks)

    @cached_property
    def _rows(self) -> list[dict[str, Any]]:
        rows: list[dict[str, Any]] = self.study.to_dict()["rows"]
        return rows
