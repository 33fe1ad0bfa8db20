"""A sweep in chunks: a point of the grid and a range of trials, computed anywhere."""

import hashlib
import itertools
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from typing import Any, Literal

import numpy as np

from .. import _core
from ..arrays import Floats
from ..families import AnyScenario
from ..indoor import IndoorScenario
from ..kinematics import KinematicsScenario
from ..scenario import Scenario

Kind = Literal["track", "localize", "indoor", "kinematics"]
KINDS: tuple[tuple[type, tuple[Kind, ...]], ...] = (
    (Scenario, ("track", "localize")),
    (IndoorScenario, ("indoor",)),
    (KinematicsScenario, ("kinematics",)),
)
"""The kinds of studies that each family has, the usual one first."""
Point = dict[str, Any]
Grid = Mapping[str, Sequence[Any]]


def kind_of(scenario: AnyScenario, wished: Kind | None) -> Kind:
    """The kind that is wished for, or the usual one of the family.

    Raises:
        Error: where the family has no such study.
    """
    kinds = next(kinds for family, kinds in KINDS if isinstance(scenario, family))
    if wished is not None and wished not in kinds:
        raise _core.Error(f"{type(scenario).__name__} has no study of the kind {wished}; there is: {', '.join(kinds)}")
    return wished or kinds[0]


def plan_of(kind: Kind, text: str, trials: int) -> _core.Plan:
    """The study of one point of the grid."""
    if kind == "indoor":
        return _core.Plan.indoor(_core.IndoorScenario(text), trials)
    if kind == "kinematics":
        return _core.Plan.kinematics(_core.KinematicsScenario(text), trials)
    scenario = _core.Scenario(text)
    if kind == "localize":
        return _core.Plan.localize(scenario, json.dumps([json.loads(text)["noise"]]), trials)
    return _core.Plan.track(scenario, trials)


@dataclass(frozen=True)
class Chunk:
    """Consecutive jobs of one point."""

    kind: Kind
    text: str
    trials: int
    jobs: range
    trials_per_job: int

    def run(self) -> Floats:
        """The sums of its jobs: jobs x numbers."""
        plan = plan_of(self.kind, self.text, self.trials)
        return np.stack([plan.job(index) for index in self.jobs])

    @property
    def last(self) -> int:
        """The trial after its last."""
        return min(self.trials, self.jobs.stop * self.trials_per_job)

    @property
    def key(self) -> str:
        """The same for the same numbers: of this version, scenario and range of trials."""
        what = [version("rangelab"), self.kind, self.text, self.jobs.start * self.trials_per_job, self.last]
        return hashlib.sha256(json.dumps(what).encode()).hexdigest()[:32]


def points_of(grid: Grid) -> list[Point]:
    """Every combination, the last parameter changing fastest."""
    return [dict(zip(grid, values, strict=True)) for values in itertools.product(*grid.values())]


def chunks_of(kind: Kind, scenario: AnyScenario, trials: int, size: int) -> Iterator[Chunk]:
    """The chunks of one point, of about `size` trials each."""
    text = scenario.to_json()
    plan = plan_of(kind, text, trials)
    each = max(1, round(size / plan.trials_per_job))
    for first in range(0, plan.jobs, each):
        yield Chunk(kind, text, trials, range(first, min(plan.jobs, first + each)), plan.trials_per_job)


def joined(kind: Kind, text: str, trials: int, chunks: list[Floats]) -> dict[str, Any]:
    """The report of one point from all its chunks, in order: the crate refuses one that is missing or comes twice."""
    total = plan_of(kind, text, trials).start()
    for chunk in chunks:
        for numbers in chunk:
            # What comes over the wire may lie anywhere in memory.
            total.push(np.require(numbers, np.float64, ["C", "A"]))
    report: dict[str, Any] = json.loads(total.report())
    return report
