"""The answer of a snapshot estimator."""

from dataclasses import dataclass

import numpy as np

from . import _core
from .arrays import Floats
from .documents import Document, to_text


@dataclass(frozen=True)
class Snapshot:
    """A pose from one epoch alone."""

    pose: tuple[Floats, Floats] | None
    """`Q` (D x D) and `t` (D, m); None for the classical LS, which sees no body."""
    iterations: int
    """Iterations until the stopping rule held."""
    reflected: bool
    """`Q` mirrors the body."""
    optimum: str
    """What is known of the optimum: formula, certified, searched or local."""

    @property
    def orientation(self) -> Floats:
        """`Q`: D x D."""
        return self._known()[0]

    @property
    def position(self) -> Floats:
        """`t`, m: D."""
        return self._known()[1]

    def _known(self) -> tuple[Floats, Floats]:
        if self.pose is None:
            raise _core.Error("this estimator sees sensors, and no body")
        return self.pose


def settings_scenario(dimension: int, settings: Document) -> _core.Scenario:
    """A scenario that carries settings of localizers, checked as every scenario is."""
    document = {
        "version": 1,
        "dimension": dimension,
        "anchors": np.eye(dimension + 1, dimension),
        "sensors": np.eye(dimension + 1, dimension),
        "noise": {"kind": "range", "sigma": 1.0},
        "localize": settings,
    }
    return _core.Scenario(to_text(document))
