"""Motions of a network of nodes."""

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from .arrays import Floats


class RelativeKinematics:
    """Positions, velocities, accelerations and so on of all nodes at time 0, `X(t) = sum_l Y_l t^l/l!`; immutable.

    Raises:
        Error: where the coefficients are not (L + 1) x N x D finite numbers.

    >>> motion = RelativeKinematics([[[0, 0], [2, 4]], [[1, 0], [0, 0]]])
    >>> motion.positions(3.0).tolist()
    [[[3.0, 0.0], [2.0, 4.0]]]

    """

    def __init__(self, coefficients: ArrayLike) -> None:
        self._core = _core.RelativeKinematics(np.asarray(coefficients, dtype=np.float64))

    @classmethod
    def _of(cls, core: _core.RelativeKinematics) -> "RelativeKinematics":
        motion = cls.__new__(cls)
        motion._core = core
        return motion

    @property
    def coefficients(self) -> Floats:
        """`Y_0, ..., Y_L`, m/s^l: (L + 1) x N x D."""
        return self._core.coefficients()

    @property
    def gram(self) -> Floats:
        """`B_0, ..., B_2L`, `X^T X = sum_l B_l t^l`, m^2/s^l: (2 L + 1) x N x N."""
        return self._core.gram()

    def positions(self, times: ArrayLike) -> Floats:
        """At each time (s), m: T x N x D."""
        return self.derivative(0, times)

    def derivative(self, order: int, times: ArrayLike) -> Floats:
        """Velocities for 1, accelerations for 2, at each time (s), m/s^order: T x N x D."""
        return self._core.derivative(order, np.asarray(times, dtype=np.float64).reshape(-1))

    def centred(self) -> "RelativeKinematics":
        """Each coefficient less its mean over the nodes."""
        return self._of(self._core.centred())

    def aligned_to(self, truth: "RelativeKinematics") -> "RelativeKinematics":
        """In the frame of `truth`: one element of O(D), from `Y_0`, for all coefficients, both centred."""
        return self._of(self._core.aligned_to(truth._core))

    def __reduce__(self) -> tuple[type["RelativeKinematics"], tuple[Floats]]:
        return type(self), (self.coefficients,)

    def __repr__(self) -> str:
        count, nodes, dimension = self.coefficients.shape
        return f"<rangelab.RelativeKinematics: {nodes} nodes in {dimension} dimensions, degree {count - 1}>"
