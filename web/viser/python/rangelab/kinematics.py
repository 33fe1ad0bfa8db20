"""The Anchorless lab: mobile nodes that measure the distances between each other, and their accelerations.

In shapes N counts nodes, K stamps, T times, L is the degree of the motion `X(t) = sum_l Y_l t^l/l!`; vectors are rows.
"""

import json
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from .arrays import Floats
from .distances import DistanceRecord
from .documents import Document, Written, to_text
from .gram_spectrum import GramSpectrum
from .html import card
from .jobs import Progress
from .kinematics_run import KinematicsRun
from .motion import RelativeKinematics
from .studies import Study, kinematics_study


def kinematics_presets() -> list[dict[str, str]]:
    """The kinematics scenarios that come with rangelab: `name`, `title`, `summary`."""
    found: list[dict[str, str]] = json.loads(_core.kinematics_presets())
    return found


@dataclass(frozen=True)
class SimulatedKinematics:
    """One trial: what was measured, and what was true."""

    record: DistanceRecord
    """What estimators see."""
    truth: RelativeKinematics
    """The motion, centred, in the frame of the scenario."""
    sensor_from_world: Floats
    """`Q`, from that frame to that of the accelerometers, another one in each trial: D x D."""


class KinematicsScenario(Written):
    """A simulated network of mobile nodes; immutable. Version and coefficients ((L + 1) x N x D, m/s^l) must be given.

    Raises:
        InvalidDocument: with every problem, its path, value and limit, in `problems`.

    >>> KinematicsScenario({"version": 1, "coefficients": [[[0, 0], [3, 0], [0, 4]], [[1, 0], [0, 0], [0, 1]]]}).nodes
    3

    """

    def __init__(self, document: Document | str) -> None:
        self._core = _core.KinematicsScenario(to_text(document))

    @classmethod
    def preset(cls, name: str = "kinematics-paper") -> "KinematicsScenario":
        """A scenario of `rangelab.kinematics_presets()`."""
        return cls(_core.KinematicsScenario.preset(name).to_json())

    def to_json(self) -> str:
        """The whole scenario as JSON; every number comes back as the same bits."""
        return self._core.to_json()

    @property
    def motion(self) -> RelativeKinematics:
        """The true motion as given, which need not be centred."""
        return RelativeKinematics(self.to_dict()["coefficients"])

    @property
    def nodes(self) -> int:
        """N."""
        return len(self.to_dict()["coefficients"][0])

    def simulate(self, trial: int = 0) -> SimulatedKinematics:
        """What the nodes measure in one trial."""
        record, truth, sensor_from_world = self._core.simulate(trial)
        return SimulatedKinematics(DistanceRecord._of(record), RelativeKinematics._of(truth), sensor_from_world)

    def run(self, trial: int = 0) -> KinematicsRun:
        """Simulates one trial and runs the enabled estimators; one that fails says so in its own part."""
        return KinematicsRun(self._core.run(trial))

    def gram_spectrum(self, trial: int = 0) -> GramSpectrum:
        """Of the Gram matrices of one trial: D eigenvalues stand out, the others are noise.

        >>> spectrum = KinematicsScenario.preset().gram_spectrum()
        >>> bool(spectrum.fitted[1] > 1000 * abs(spectrum.fitted[2]))
        True

        """
        return GramSpectrum.from_json(self._core.gram_spectrum(trial))

    def bound(self, accelerations: bool = False) -> "KinematicsBound":
        """The Cramér-Rao bound at the true motion, from distances alone or with accelerations.

        That of studies: where estimators assume a higher degree than the motion has, for the coefficients up to theirs.

        Raises:
            Error: where the motion is not determined to first order, with the reason.

        """
        return KinematicsBound(self._core.bound(accelerations))

    def study(self, trials: int = 200, *, threads: int | None = None, progress: Progress | None = None) -> Study:
        """Monte-Carlo of the enabled estimators beside both bounds, as `Scenario.study`.

        Its rows are of two kinds: with an `order` l of coefficients (m/s^l) and Gram matrices (m^2/s^l), and with an
        `instant` (s) of positions (m).
        """
        return kinematics_study(self._core, trials, threads, progress)

    def _summary(self) -> str:
        coefficients = self.to_dict()["coefficients"]
        space = "the plane" if len(coefficients[0][0]) == 2 else "space"
        return f"{len(coefficients[0])} nodes in {space}, degree {len(coefficients) - 1}"

    def __repr__(self) -> str:
        return f"<rangelab.KinematicsScenario {self.to_dict()['name']!r}: {self._summary()}>"

    def _repr_html_(self) -> str:
        document = self.to_dict()
        rows = {
            "noise": ", ".join(f"{key} {value}" for key, value in document["noise"].items()),
            "estimators": ", ".join(document["estimators"]["enabled"]),
        }
        return card(f"Kinematics scenario {document['name']}", self._summary(), rows)


class KinematicsBound:
    """How well any unbiased estimator could find a motion; errors are compared after alignment, to first order.

    One element of O(D) aligns all, from the positions at time 0; with `at_each` positions are aligned at each time.
    """

    def __init__(self, core: _core.KinematicsBound) -> None:
        self._core = core

    def coefficient_rmse(self, order: int) -> float:
        """Least root mean square error of a coordinate of `Y_l`, m/s^l."""
        return self._core.coefficient_rmse(order)

    def coefficient_covariance(self, order: int) -> Floats:
        """Of `Y_l`, node by node, (m/s^l)^2: (N D) x (N D)."""
        return self._core.coefficient_covariance(order)

    def gram_rmse(self, order: int) -> float:
        """Least root mean square error of an entry of `vech(B_l)`, `X^T X = sum_l B_l t^l`, m^2/s^l."""
        return self._core.gram_rmse(order)

    def position_rmse(self, times: ArrayLike, *, at_each: bool = False) -> Floats:
        """Least root mean square error of a coordinate at each time (s), m: T."""
        return self._core.position_rmse(np.asarray(times, dtype=np.float64).reshape(-1), at_each)

    def position_covariance(self, time: float, *, at_each: bool = False) -> Floats:
        """Of the positions at a time (s), node by node, m^2: (N D) x (N D)."""
        return self._core.position_covariance(time, at_each)
