"""What the anchors cannot show, or show badly: the direction that is known worst, and why."""

from dataclasses import dataclass

import numpy as np

from ...arrays import Floats
from ...run import Run
from ..readout import reading
from ..words import number, start_of
from .findings import Finding, as_sentence, count_of

ALIGNED = 0.966
"""How much of a direction must lie along an axis to be called by its name: within 15 degrees of it."""
TELLING = 3.0
"""Below this ratio nobody would call a direction weak."""
FLAT = 0.15
"""Anchors thinner than this part of their extent are called flat."""
NORMAL = 0.8
"""How much of the weak direction must be the plane's normal for the plane to be its cause."""


@dataclass(frozen=True)
class WeakDirection:
    """The one direction in which a position is known clearly worse than across it."""

    name: str
    direction: Floats
    ratio: float
    """Standard deviation along it over the root mean square of those across it."""


def weak_direction(covariance: Floats) -> WeakDirection | None:
    """Of the covariance of a position, D x D; None where no direction is weak."""
    if not np.isfinite(covariance).all():
        return None
    variances, vectors = np.linalg.eigh(covariance)
    across, along = np.sqrt(variances[:-1].mean()), np.sqrt(variances[-1])
    if not across > 0 or not along / across >= TELLING:
        return None
    return WeakDirection(_name_of(vectors[:, -1]), vectors[:, -1], float(along / across))


def _name_of(direction: Floats) -> str:
    axis = int(np.abs(direction).argmax())
    if abs(direction[axis]) > ALIGNED:
        return ("x", "y", "height")[axis]
    sign = np.sign(direction[np.nonzero(direction)[0][-1]])
    return f"position along ({', '.join(number(round(sign * part, 1) + 0.0) for part in direction)})"


def weak_geometry(run: Run, step: int) -> Finding | None:
    """What cannot be seen, else what is seen badly."""
    if run.unseen:
        return Finding(as_sentence(run.unseen), 65)
    bound = run.bounds.get("posterior_crb")
    weak = None if bound is None else weak_direction(bound.position_covariances[step])
    if weak is None:
        return None
    weight, times = 40 + min(20.0, weak.ratio), number(float(f"{weak.ratio:.2g}"))
    effect = f"{weak.name} is known {times} times worse than position"
    cause = _thin_cause(run, weak.direction)
    if cause is None:
        return Finding(start_of(f"{effect} across it."), weight)
    return Finding(f"{cause}: {effect} {'in' if run.dimension == 3 else 'along'} it.", weight)


def _thin_cause(run: Run, direction: Floats) -> str | None:
    """That anchors lie within so many metres of one plane, where that is why the direction is weak."""
    lie = f"{start_of(count_of(len(run.anchors)))} anchors lie"
    extent = float(np.linalg.norm(run.anchors - run.anchors[0], axis=1).max())
    kind = "plane" if run.dimension == 3 else "line"
    thin = run.geometry["anchors"][kind]
    if thin is None or thin["thickness"] >= FLAT * extent:
        return None
    cosine = abs(float(np.dot(thin["direction"], direction)))
    caused = cosine > NORMAL if kind == "plane" else cosine < np.sqrt(1 - NORMAL**2)
    return f"{lie} within {reading(thin['thickness'])} m of one {kind}" if caused else None
