"""What each estimator of the Anchorless lab reached, in one trial or on the average over many, beside its bound."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ...arrays import Floats
from ...distances import kinematics_estimators
from ...kinematics_run import KinematicsRun
from ...studies import Curve, Study
from ..looks import KINEMATICS, KINEMATICS_BOUNDS
from ..plots import Line
from . import drawing

SENSES = {name: senses for name, _, senses in kinematics_estimators()}
"""Whether an estimator reads accelerometers."""


@dataclass(frozen=True)
class Level:
    """One estimator."""

    name: str
    errors: Sequence[float]
    """Root mean square errors of `Y_0, Y_1, ...`, m/s^l."""
    standard_errors: Sequence[float] | None
    """Of these; None of one trial."""
    bounds: Sequence[float]
    """On the errors; empty where there are none."""
    last: tuple[float, float]
    """At the last instant with one alignment, and aligned then, m."""

    @property
    def label(self) -> str:
        """As it is named everywhere."""
        return KINEMATICS[self.name].label

    @property
    def senses(self) -> bool:
        """Whether it reads accelerometers."""
        return SENSES[self.name]

    def over_bound(self, order: int) -> float | None:
        """How many times its bound an error is; None where there is no bound or no such coefficient."""
        known = order < min(len(self.errors), len(self.bounds)) and self.bounds[order] > 0
        return self.errors[order] / self.bounds[order] if known else None


def bound_of(name: str) -> str:
    """The bound that knows what an estimator knows."""
    return "accelerometers" if SENSES[name] else "distances"


def bound_kinds(enabled: Sequence[str]) -> list[str]:
    """The bounds that belong to what is switched on."""
    return list(KINEMATICS_BOUNDS) if any(SENSES[name] for name in enabled) else ["distances"]


def levels_of_run(run: KinematicsRun, bounds: Mapping[str, Sequence[float]]) -> list[Level]:
    """Of one trial; estimators that find no motion are left out."""
    return [
        Level(
            name,
            each.coefficient_errors.tolist(),
            None,
            bounds.get(bound_of(name), ()),
            (float(each.position_errors[-1]), float(each.aligned_position_errors[-1])),
        )
        for name, each in run.estimators.items()
        if len(each.coefficient_errors)
    ]


class Report:
    """The figures of a study of networks, by estimator and by bound."""

    def __init__(self, study: Study) -> None:
        self.trials, self._report = study.trials, study.to_dict()
        self.stamps = int(self._report["stamps"])
        """K."""
        self.instants = np.array(self._report["instants"], dtype=np.float64)
        """When positions are compared, s."""
        self.summaries: dict[str, dict[str, Any]] = {
            each["name"]: each["summary"] for each in self._report["estimators"]
        }

    @cached_property
    def bounds(self) -> dict[str, dict[str, Any]]:
        """Those that belong to what is switched on."""
        found = {"accelerometers" if each["accelerations"] else "distances": each for each in self._report["bounds"]}
        return {kind: found[kind] for kind in bound_kinds(list(self.summaries)) if kind in found}

    def coefficients(self, kind: str) -> list[float]:
        """The bound on `Y_0, Y_1, ...`; empty where there is none."""
        return list(self.bounds.get(kind, {}).get("coefficients") or ())

    @property
    def levels(self) -> list[Level]:
        """Of those that found a motion."""
        summaries = self.summaries.items()
        return [self._level(name, found) for name, found in summaries if found["trials"] and found["coefficients"]]

    def _level(self, name: str, found: dict[str, Any]) -> Level:
        errors = Curve.of(found["coefficients"])
        last = found["positions"][-1]["value"], found["aligned_positions"][-1]["value"]
        bounds = self.coefficients(bound_of(name))
        return Level(name, errors.values.tolist(), errors.standard_errors.tolist(), bounds, last)

    def lines(self, of: str) -> tuple[Line, ...]:
        """Bounds, and estimators with bands of two standard errors, over the instants."""
        bounds = {kind: np.array(each[of] or ()) for kind, each in self.bounds.items()}
        curves = {name: Curve.of(found[of]) for name, found in self.summaries.items() if found[of]}
        return bound_lines(bounds) + drawing.banded(KINEMATICS, curves)


def bound_lines(bounds: Mapping[str, Floats]) -> tuple[Line, ...]:
    """Those that there are."""
    return tuple(Line(KINEMATICS_BOUNDS[kind], values, 1.5) for kind, values in bounds.items() if len(values))
