"""How the body is drawn that has moved along the motion that ranges see least."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...arrays import Floats
from .. import shapes
from .drawing import round_times

LEAST, UNSEEN = 0.25, 0.6
"""Shares of the body's radius: those that move by less are not seen, in one that no range sees they move by it."""
FARTHEST_TURN = np.pi / 3
"""No ghost turns farther, rad."""


@dataclass(frozen=True)
class Motion:
    """A small motion of the body."""

    rotation: Floats
    """Rotation vector in the body frame, rad: 3."""
    shift: Floats
    """In the world frame, m: 3."""
    times: float | None
    """How many times larger than one standard deviation it is; None where the motion is not seen at all."""

    def moved(self, orientation: Floats, position: Floats, sensors: Floats, sign: float) -> Floats:
        """Places of sensors (body frame, N x D, m) in the world, moved to one side or to the other: N x 3."""
        turned = shapes.lifted(sensors) @ turn(sign * self.rotation).T
        full = np.eye(3)
        full[: len(orientation), : len(orientation)] = orientation
        return np.asarray(turned @ full.T + shapes.lifted(position) + sign * self.shift)

    @property
    def sentence(self) -> str:
        """What the ghost is."""
        if self.times is None:
            return "Ghost (blue): the motion that no range sees."
        sigma = "one σ" if self.times == 1 else f"{self.times:g} σ"
        return f"Ghost (blue): the motion seen least, by {sigma}."


def motion_of(mode: dict[str, Any], radius: float, reach: float) -> Motion:
    """One standard deviation along a mode, larger by a round number where it would not be seen; `reach` ends shifts."""
    deviation = mode["standard_deviation"]
    times = None if deviation is None else _magnified(deviation, LEAST * radius)
    size = UNSEEN * radius if deviation is None or times is None else deviation * times
    rotation, shift = _vector(mode["rotation"], turns=True), _vector(mode["shift"], turns=False)
    lengths = (max(1e-300, float(np.linalg.norm(each))) for each in (rotation, shift))
    most = min(size, *(limit / length for limit, length in zip((FARTHEST_TURN, reach), lengths, strict=True)))
    return Motion(most * rotation, most * shift, times)


def turn(vector: Floats) -> Floats:
    """The rotation of a rotation vector (Rodrigues): 3 x 3."""
    angle = float(np.linalg.norm(vector))
    half = np.sinc(angle / (2 * np.pi)) / 2 * vector
    return shapes.rotation(np.array([np.cos(angle / 2), *half]), 3)


def _magnified(deviation: float, least: float) -> float:
    if deviation >= least:
        return 1.0
    return round_times(2 * least / max(deviation, 1e-12))


def _vector(values: list[float], *, turns: bool) -> Floats:
    """Motions of the plane turn about z."""
    if len(values) == 3:
        return np.array(values)
    return np.array([0.0, 0.0, values[0]] if turns else [*values, 0.0])
