"""Distances between nodes, and what each estimator of relative kinematics makes of them."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from .arrays import Floats
from .documents import to_text
from .motion import RelativeKinematics


def kinematics_estimators() -> list[tuple[str, str, bool]]:
    """The estimators of relative kinematics: name, label, whether it reads accelerations."""
    return _core.kinematics_estimators()


class KinematicsEstimate:
    """What one estimator found; each gives its own parts."""

    def __init__(self, core: _core.KinematicsEstimate) -> None:
        self._core = core

    @property
    def motion(self) -> RelativeKinematics | None:
        """`Y_0, ..., Y_L`, centred, up to one element of O(D); None where no motion is found."""
        motion = self._core.motion()
        return None if motion is None else RelativeKinematics._of(motion)

    @property
    def gram(self) -> Floats:
        """`B_0, B_1, ...`, `X^T X = sum_l B_l t^l`, m^2/s^l: B x N x N, B = 0 where the estimator goes another way."""
        return self._core.gram()

    @property
    def snapshots(self) -> Floats:
        """Positions at each stamp, each up to its own element of O(D), m: K x N x D, NaN where distances are missing.

        0 x N x D from estimators that do not see one epoch at a time.
        """
        return self._core.snapshots()

    @property
    def rotation(self) -> Floats | None:
        """`H_2`, or the frame `Q` of the accelerometers: D x D, None where neither is estimated."""
        return self._core.rotation()

    @property
    def acceleration_margin(self) -> float | None:
        """Least eigenvalue kept of the accelerations' Gram matrix over its most negative one; below 1 they drown."""
        return self._core.acceleration_margin

    @property
    def cost(self) -> float:
        """Of the solution that was chosen, in the estimator's own unit."""
        return self._core.cost

    @property
    def iterations(self) -> int:
        """0 for closed forms."""
        return self._core.iterations

    def __repr__(self) -> str:
        parts = {"motion": self.motion is not None, "gram": len(self.gram), "snapshots": len(self.snapshots)}
        return f"<rangelab.KinematicsEstimate: {', '.join(name for name, there in parts.items() if there)}>"


class DistanceRecord:
    """Distances between N nodes at K stamps, and accelerations where there are any; immutable.

    `distances` are K x N x N, m, of which the entries above the diagonal are read, NaN where missing; `sigma` is the
    standard deviation of each, m, 0 where they are exact. `accelerations` are K x N x D, m/s^2, in one proper frame
    that all nodes share, with `sigma_acceleration` the standard deviation of a coordinate.

    Raises:
        Error: where shapes do not agree or numbers are not finite.

    """

    def __init__(
        self,
        stamps: ArrayLike,
        distances: ArrayLike,
        *,
        sigma: float,
        dimension: int = 2,
        accelerations: ArrayLike | None = None,
        sigma_acceleration: float = 0.0,
    ) -> None:
        times, tables = (np.asarray(each, dtype=np.float64) for each in (stamps, distances))
        nodes = tables.shape[-1] if tables.ndim else 0
        needed = (times.size, nodes, nodes)
        if tables.shape != needed or times.ndim != 1:
            found = f"{times.shape} and {tables.shape}"
            raise _core.Error(f"{found} are the shapes of stamps and distances where (K,) and (K, N, N) are needed")
        above = tables[:, *np.triu_indices(nodes, 1)]
        self._core = _core.DistanceRecord(dimension, nodes, times, above, sigma)
        if accelerations is not None:
            readings = np.asarray(accelerations, dtype=np.float64)
            self._core = self._core.with_accelerometers(readings, sigma_acceleration)

    @classmethod
    def _of(cls, core: _core.DistanceRecord) -> "DistanceRecord":
        record = cls.__new__(cls)
        record._core = core
        return record

    @property
    def dimension(self) -> int:
        """D: 2 in the plane, 3 in space."""
        return self._core.dimension

    @property
    def nodes(self) -> int:
        """N."""
        return self._core.nodes

    @property
    def stamps(self) -> Floats:
        """When was measured, s: K."""
        return self._core.stamps()

    @property
    def distances(self) -> Floats:
        """Both ways, zero from a node to itself, m: K x N x N, NaN where missing."""
        i, j = np.triu_indices(self.nodes, 1)
        tables = np.zeros((len(self.stamps), self.nodes, self.nodes))
        tables[:, i, j] = tables[:, j, i] = self._core.distances()
        return tables

    @property
    def sigma(self) -> float:
        """Standard deviation of a distance, m."""
        return self._core.sigma

    @property
    def accelerations(self) -> Floats | None:
        """In the frame of the accelerometers, m/s^2: K x N x D; None where there are none."""
        return self._core.accelerations()

    @property
    def sigma_acceleration(self) -> float | None:
        """Standard deviation of a coordinate of an acceleration, m/s^2; None where there are none."""
        return self._core.sigma_acceleration

    def without_accelerations(self) -> "DistanceRecord":
        """The same distances alone."""
        return self._of(self._core.without_accelerometers())

    def estimate(
        self, estimator: str = "maximum-likelihood", *, degree: int = 2, range_degree: int = 4
    ) -> KinematicsEstimate:
        """Estimates by a name of `rangelab.kinematics_estimators()`.

        `degree` is that of the motion which is assumed, `range_degree` that of each range in `"range-polynomial"`.

        Raises:
            UnknownName: with the names that exist.
            Error: where nodes, stamps, distances or accelerations are too few, with what is missing.

        """
        settings = to_text({"degree": degree, "range_degree": range_degree})
        return KinematicsEstimate(self._core.estimate(estimator, settings))

    def __reduce__(self) -> tuple[Callable[..., "DistanceRecord"], tuple[object, ...]]:
        accelerations = None if self.accelerations is None else (self.accelerations, self.sigma_acceleration)
        return _restored, (self.stamps, self.distances, self.sigma, self.dimension, accelerations)

    def __repr__(self) -> str:
        missing = int(np.isnan(self._core.distances()).sum())
        return (
            f"<rangelab.DistanceRecord: {self.nodes} nodes at {len(self.stamps)} stamps, {missing} distances missing>"
        )


def _restored(
    stamps: Floats, distances: Floats, sigma: float, dimension: int, accelerations: tuple[Floats, float] | None
) -> DistanceRecord:
    readings, sigma_acceleration = accelerations or (None, 0.0)
    return DistanceRecord(
        stamps,
        distances,
        sigma=sigma,
        dimension=dimension,
        accelerations=readings,
        sigma_acceleration=sigma_acceleration,
    )
