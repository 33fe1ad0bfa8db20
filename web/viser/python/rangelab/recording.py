"""Recordings: what estimators are given."""

import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from .arrays import Floats
from .documents import Document, to_text
from .html import card
from .run import Run
from .snapshot import Snapshot, settings_scenario
from .tracker import Track


class Recording:
    """Ranges with the known motion between them, measured or simulated; immutable.

    `document` is a dictionary or JSON as `rangelab simulate` writes it.

    Raises:
        InvalidDocument: with every problem, its path, value and limit, in `problems`.
        Error: for text that is no JSON, and for a document of a newer version.

    """

    def __init__(self, document: Document | str) -> None:
        self._core = _core.Recording(to_text(document))

    @classmethod
    def _of(cls, core: _core.Recording) -> "Recording":
        recording = cls.__new__(cls)
        recording._core = core
        return recording

    @classmethod
    def read(cls, path: str | Path) -> "Recording":
        """A recording from a file."""
        return cls(Path(path).read_text(encoding="utf-8"))

    @classmethod
    def from_arrays(
        cls,
        *,
        anchors: ArrayLike,
        sensors: ArrayLike,
        noise: Document,
        interval: ArrayLike,
        ranges: ArrayLike | None = None,
        squared_ranges: ArrayLike | None = None,
        velocity: ArrayLike | None = None,
        angular_velocity: ArrayLike | None = None,
        **more: Any,
    ) -> "Recording":
        """A recording of ranges of your own.

        Args:
            anchors: M x D, world frame, m.
            sensors: N x D, body frame, m.
            noise: for example `{"kind": "range", "sigma": 0.05}` (m).
            interval: time since the last epoch, s: one for all, or K.
            ranges: K x M x N, m, NaN where missing; this or `squared_ranges`.
            squared_ranges: the same squared, m^2.
            velocity: K x D, world frame, m/s; zero by default.
            angular_velocity: K x A, world frame, rad/s; zero by default.
            more: other entries of the document, such as `initial`, `process` or `name`.
        """
        squared = _squared(ranges, squared_ranges)
        dimension = np.shape(anchors)[-1]
        document = {
            "version": 1,
            "dimension": dimension,
            "anchors": np.asarray(anchors, dtype=np.float64),
            "sensors": np.asarray(sensors, dtype=np.float64),
            "noise": noise,
            "epochs": _epochs(len(squared), dimension, interval, velocity, angular_velocity),
            **more,
            "initial": _belief(dimension) | more.get("initial", {}),
        }
        return cls._of(_core.Recording.with_squared_ranges(to_text(document), squared))

    def to_json(self) -> str:
        """The recording as JSON; every number comes back as the same bits."""
        return self._core.to_json()

    def to_dict(self) -> dict[str, Any]:
        """The recording as a dictionary, a copy."""
        document: dict[str, Any] = json.loads(self.to_json())
        return document

    @property
    def dimension(self) -> int:
        """D: 2 in the plane, 3 in space."""
        return self._core.dimension

    @property
    def epochs(self) -> int:
        """K, how many epochs there are."""
        return self._core.epochs

    @property
    def anchors(self) -> Floats:
        """World frame, m: M x D."""
        return self._core.anchors()

    @property
    def sensors(self) -> Floats:
        """Body frame, m: N x D."""
        return self._core.sensors()

    @property
    def intervals(self) -> Floats:
        """Time since the last epoch, s: K."""
        return self._core.intervals()

    @property
    def velocities(self) -> Floats:
        """Known linear velocity in the world frame, m/s: K x D."""
        return self._core.velocities()

    @property
    def angular_velocities(self) -> Floats:
        """Known angular velocity in the world frame, rad/s: K x A."""
        return self._core.angular_velocities()

    @property
    def squared_ranges(self) -> Floats:
        """Squared ranges, m^2: K x M x N, NaN where missing."""
        return self._core.squared_ranges()

    @property
    def truth_orientations(self) -> Floats:
        """True orientations: K x D x D, NaN where not known."""
        return self._core.truth_orientations()

    @property
    def truth_positions(self) -> Floats:
        """True positions, m: K x D, NaN where not known."""
        return self._core.truth_positions()

    def run(self, estimators: Document | None = None) -> Run:
        """Runs trackers, and bounds where the truth is known.

        `estimators` are settings as in a scenario, for example `{"enabled": ["kf", "uc-kf"]}`; by default all run.
        """
        return Run(self._core.run(to_text(estimators or {})))

    def track(self, estimator: str = "uc-kf", settings: Document | None = None) -> Track:
        """Runs one tracker alone, without bounds and errors: the fastest way to a track."""
        return Track(*self._core.track(estimator, to_text(settings or "{}")))

    def localize(self, localizer: str = "ouc-ls", epoch: int = 0, settings: Document | None = None) -> Snapshot:
        """The pose from the ranges of one epoch alone.

        `settings` are those of a scenario's `localize`, for example `{"multi_start": True}`.

        Raises:
            Unobservable: where the ranges do not show the pose, with the reason.
            NoConvergence: where an iteration does not settle.

        """
        scenario = settings_scenario(self.dimension, settings or {})
        return Snapshot(*_core.localize_recording(self._core, epoch, localizer, scenario))

    def __reduce__(self) -> tuple[type["Recording"], tuple[str]]:
        return type(self), (self.to_json(),)

    def _summary(self) -> str:
        _, m, n = self.squared_ranges.shape
        missing = int(np.isnan(self.squared_ranges).sum())
        space = "the plane" if self.dimension == 2 else "space"
        return f"{self.epochs} epochs of {m} x {n} ranges in {space}, {missing} missing"

    def __repr__(self) -> str:
        return f"<rangelab.Recording: {self._summary()}>"

    def _repr_html_(self) -> str:
        known = "known" if np.isfinite(self.truth_positions).all() else "not known"
        return card("Recording", self._summary(), {"time": f"{self.intervals.sum():g} s", "truth": known})


def _belief(dimension: int) -> dict[str, Any]:
    """The identity at the origin, very uncertain."""
    return {"orientation": np.eye(dimension), "position": np.zeros(dimension), "covariance": 100.0}


def _squared(ranges: ArrayLike | None, squared_ranges: ArrayLike | None) -> Floats:
    """The squared ranges, whichever of the two is given, m^2: K x M x N."""
    if (ranges is None) == (squared_ranges is None):
        raise _core.Error("ranges and squared_ranges: one of the two is needed")
    measured = np.asarray(ranges if squared_ranges is None else squared_ranges, dtype=np.float64)
    return np.atleast_1d(np.ascontiguousarray(measured**2 if squared_ranges is None else measured))


def _epochs(
    count: int,
    dimension: int,
    interval: ArrayLike,
    velocity: ArrayLike | None,
    angular_velocity: ArrayLike | None,
) -> list[dict[str, Any]]:
    """The epochs of a document: how the body moves in each, without ranges."""
    motion = zip(
        np.broadcast_to(np.asarray(interval, dtype=np.float64), count).tolist(),
        _per_epoch(velocity, count, dimension),
        _per_epoch(angular_velocity, count, dimension * (dimension - 1) // 2),
        strict=True,
    )
    return [{"interval": t, "velocity": v, "angular_velocity": w} for t, v, w in motion]


def _per_epoch(given: ArrayLike | None, count: int, width: int) -> list[Any]:
    """The same for all epochs or one row each; zeros where nothing is given."""
    values = np.zeros(width) if given is None else np.asarray(given, dtype=np.float64)
    try:
        found: list[Any] = np.broadcast_to(values, (count, width)).tolist()
    except ValueError:
        raise _core.Error(f"{values.shape} is the shape where {(count, width)} is needed") from None
    return found
