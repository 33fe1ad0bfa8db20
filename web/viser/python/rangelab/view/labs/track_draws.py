"""Anchors fixed against anchors drawn anew: the page's study "Anchor draws"."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ...arrays import Floats
from ...draws import AnchorDraws
from ...jobs import Progress
from ...scenario import Scenario
from ..looks import TRACK_BOUNDS, TRACKERS, Look
from ..panel import DEGREES
from ..plots import Line, Plot
from ..readout import reading
from ..study_page import StudyPage
from ..uprights import Upright

MOST = 500
"""No more draws than a plot shows as points."""
PARTS = {"kf": TRACKERS["kf"], "uc-kf": TRACKERS["uc-kf"], "posterior_crb": TRACK_BOUNDS["posterior_crb"]}
WIDTHS = {"kf": 2.0, "uc-kf": 1.6, "posterior_crb": 1.0}
"""Dots that are drawn later are smaller, so that all are seen."""
FIXED, REDRAWN = 0, 1


def subject(scenario: Any) -> Any:
    """What the study depends on: it is of the KF and the UC-KF whichever are switched on."""
    document = scenario.to_dict()
    return document | {"estimators": document.get("estimators", {}) | {"enabled": []}}


def anchor_draws(scenario: Scenario, trials: int, progress: Progress) -> "Draws":
    """Runs it.

    Raises:
        Cancelled: where progress says so before the first draws.
        Error: in a sentence.
    """
    asked = min(trials, MOST)
    return Draws(subject(scenario), asked, scenario.anchor_draws(asked, progress=progress))


@dataclass(frozen=True, eq=False)
class Draws(StudyPage):
    """Errors of each draw over the condition of its anchors."""

    draws: AnchorDraws

    subject = staticmethod(subject)

    @property
    def trials(self) -> int:
        """Draws that were made."""
        return len(self.draws.numbers)

    def plots(self, document: dict[str, Any]) -> list[Plot]:
        """Points of the draws; levels where the fixed anchors have them. Draws in a plane have no condition."""
        del document
        conditions = self.draws.conditions[:, REDRAWN]
        order = np.argsort(conditions)[: int(np.isfinite(conditions).sum())]
        x, axis = conditions[order], "condition of the anchors"
        angles = self._lines({name: DEGREES * self.draws.angles(name) for name in PARTS}, order)
        positions = self._lines({name: self.draws.positions(name) for name in PARTS}, order)
        fixed = self._fixed_condition
        marks = (Upright(fixed, Look("fixed anchors", "anchor", dash=(7, 4))),) if np.isfinite(fixed) else ()
        return [
            Plot("Orientation by anchor condition, deg", x, angles, axis, logarithmic_x=True, uprights=marks),
            Plot("Position by anchor condition, m", x, positions, axis, logarithmic_x=True, uprights=marks),
        ]

    def sentence(self, document: dict[str, Any]) -> str:
        """How the draws are conditioned, and what they do to whom, beside the fixed anchors."""
        del document
        draws = self.draws
        middle, most, nearly_all = (reading(each) for each in _quantiles(draws.conditions[:, REDRAWN], 0.5, 0.95, 0.99))
        fixed = reading(self._fixed_condition) if np.isfinite(self._fixed_condition) else "in a plane"
        return "; ".join(
            [
                f"{self.trials} draws within ±{reading(draws.half_width)} m. "
                f"Condition: median {middle}, 95 % below {most}, 99 % below {nearly_all}",
                f"fixed {fixed} (dashed). Median and 95 %: KF {_told(draws.angles('kf'), DEGREES, '°')}",
                f"UC-KF {_told(draws.angles('uc-kf'), DEGREES, '°')}",
                f"position {_told(draws.positions('uc-kf'), 1.0, ' m')}.",
            ]
        )

    @property
    def _fixed_condition(self) -> float:
        return float(self.draws.conditions[0, FIXED])

    def _lines(self, values: dict[str, Floats], order: Any) -> tuple[Line, ...]:
        """The draws as points, and as levels the medians over the fixed anchors."""
        lines = []
        for name, each in values.items():
            look = replace(PARTS[name], dash=())
            lines.append(Line(look, each[order, REDRAWN], WIDTHS[name], dots=True))
        for name, each in values.items():
            level = Look(f"{PARTS[name].label}, fixed", PARTS[name].token, dash=(7, 4))
            lines.append(Line(level, np.full(len(order), _quantiles(each[:, FIXED], 0.5)[0])))
        return tuple(lines)


def _told(values: Floats, factor: float, unit: str) -> str:
    middle, most = (reading(factor * each) for each in _quantiles(values[:, REDRAWN], 0.5, 0.95))
    return f"{middle} and {most}{unit} (fixed {reading(factor * _quantiles(values[:, FIXED], 0.5)[0])}{unit})"


def _quantiles(numbers: Floats, *shares: float) -> list[float]:
    """Between the numbers in their order, NaN among them left out; NaN for no numbers."""
    known = numbers[~np.isnan(numbers)]
    return [float(np.quantile(known, share)) if len(known) else np.nan for share in shares]
