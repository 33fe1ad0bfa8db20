"""One tracker by itself."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from .arrays import Flags, Floats
from .documents import Document, to_text

if TYPE_CHECKING:
    from .recording import Recording


@dataclass(frozen=True)
class Track:
    """What one tracker reported, epoch by epoch; NaN after a failure."""

    orientations: Floats
    """`Q` as reported: K x D x D."""
    positions: Floats
    """`t`, m: K x D."""
    position_covariances: Floats
    """m^2: K x D x D."""
    rotation_covariances: Floats
    """Of the rotation vector of the error in the world frame, rad^2: K x A x A."""
    nis: Floats
    """Normalized innovations squared: K."""
    events: Flags
    """Where `Q` was projected: K."""
    failure: tuple[int, str] | None
    """The epoch at which it stopped, and why."""


class Tracker:
    """A tracker that waits for the next ranges.

    `like` is a recording whose anchors, sensors, noise, process noise and initial belief it takes; that recording's own
    epochs are not read. Weights come from the measured ranges.

    >>> import rangelab
    >>> recording = rangelab.Scenario.preset("room").simulate()
    >>> tracker = rangelab.Tracker(recording, "uc-kf")
    >>> tracker.step(1.0, recording.squared_ranges[0]).positions.shape
    (1, 3)
    """

    def __init__(self, like: "Recording", estimator: str = "uc-kf", settings: Document | None = None) -> None:
        self._core = _core.Tracker(estimator, to_text(settings or {}), like._core)
        self._dimension = like._core.dimension

    def step(
        self,
        interval: float,
        squared_ranges: ArrayLike,
        velocity: ArrayLike | None = None,
        angular_velocity: ArrayLike | None = None,
    ) -> Track:
        """Predicts over `interval` (s) and updates with squared ranges (M x N, m^2, NaN where missing).

        Velocities are those of the world frame, D numbers in m/s and A in rad/s; zero by default.

        Raises:
            Error: where the arithmetic leaves double precision; the tracker keeps its state from before the step.

        """
        turning = self._dimension * (self._dimension - 1) // 2
        arrays = self._core.step(
            interval,
            _given(velocity, self._dimension),
            _given(angular_velocity, turning),
            np.asarray(squared_ranges, dtype=np.float64),
        )
        return Track(*arrays)


def _given(values: ArrayLike | None, count: int) -> Floats:
    return np.zeros(count) if values is None else np.asarray(values, dtype=np.float64)
