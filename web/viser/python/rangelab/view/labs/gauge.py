"""What distances cannot see: the whole network turned about a point, mirrored, and shifted.

It is the page's hint `view.gauge`: it travels with a link, changes what is seen, and leaves the motion as it is.
"""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from ...arrays import Floats
from ...motion import RelativeKinematics
from ..panel import DEGREES, Document
from ..picture import Change

QUARTERS = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))
"""Cosines and sines of quarter turns, which are exact."""


@dataclass(frozen=True)
class Gauge:
    """How a network is seen."""

    degrees: float
    """Counter-clockwise, in space about the vertical."""
    mirrored: bool
    """In x, before the turn."""
    shift: Sequence[float]
    """m, as many as there are dimensions."""
    pivot: Sequence[float]
    """The point that is turned about and mirrored at, chosen when the gauge is first used, m."""

    @property
    def is_identity(self) -> bool:
        """Whether all is seen as it is."""
        return self.degrees == 0 and not self.mirrored and not any(self.shift)

    @property
    def matrix(self) -> Floats:
        """The turn after the mirror, an element of O(D): D x D."""
        c, s = _cosine_and_sine(self.degrees)
        matrix = np.eye(len(self.shift))
        matrix[:2, :2] = np.array([[c, -s], [s, c]]) @ np.diag([-1.0 if self.mirrored else 1.0, 1.0])
        return matrix

    def turned(self, vectors: Floats) -> Floats:
        """Velocities or accelerations (... x D) as they are seen."""
        return np.asarray(vectors @ self.matrix.T)

    def turned_back(self, vectors: Floats) -> Floats:
        """And back."""
        return np.asarray(vectors @ self.matrix)

    def placed(self, points: Floats) -> Floats:
        """Places (... x D, m) as they are seen."""
        return np.asarray(self.turned(points - np.array(self.pivot)) + np.array(self.pivot) + np.array(self.shift))

    def placed_back(self, points: Floats) -> Floats:
        """And back."""
        return np.asarray(self.turned_back(points - np.array(self.pivot) - np.array(self.shift)) + self.pivot)


@dataclass(frozen=True)
class Evidence:
    """How far a gauge changes what should not change, over some instants."""

    distance: float
    """Largest change of a distance between two nodes, m."""
    arrow: float
    """Largest change of the length of a velocity or an acceleration, m/s^l."""
    turn: float
    """Largest difference between the turns of two arrows, degrees; 0 where fewer than two have a direction."""


def gauge_of(document: Document) -> Gauge:
    """The gauge of a scenario; a hint may be anything, and one that does not fit is as none."""
    points = document["coefficients"][0]
    dimension, hint = len(points[0]), (document["view"] or {}).get("gauge")
    if isinstance(hint, dict) and _fits(hint, dimension):
        return Gauge(hint["degrees"], hint.get("mirrored") is True, hint["shift"], hint["pivot"])
    pivot = np.floor(np.mean(points, axis=0) + 0.5).tolist()
    return Gauge(0.0, False, [0.0] * dimension, pivot)


def with_gauge(**changes: Any) -> Change:
    """The edit that shows a scenario in another gauge; none is no hint at all."""

    def change(scenario: Any) -> Any:
        document = scenario.to_dict()
        gauge = replace(gauge_of(document), **changes)
        others = {key: value for key, value in (document["view"] or {}).items() if key != "gauge"}
        view = others if gauge.is_identity else {**others, "gauge": asdict(gauge)}
        return scenario.replace(view=view or None)

    return change


def seen(document: Document) -> Floats:
    """The coefficients of the motion as they are seen: (L + 1) x N x D."""
    gauge, coefficients = gauge_of(document), np.array(document["coefficients"], dtype=np.float64)
    if gauge.is_identity:
        return coefficients
    return np.concatenate([gauge.placed(coefficients[:1]), gauge.turned(coefficients[1:])])


def evidence_of(document: Document, times: Sequence[float]) -> Evidence:
    """What the gauge of a scenario leaves as it is, at these times (s)."""
    return _evidence(np.array(document["coefficients"], dtype=np.float64), seen(document), times, gauge_of(document))


def _evidence(before: Floats, after: Floats, times: Sequence[float], gauge: Gauge) -> Evidence:
    here, there = _distances(before, times), _distances(after, times)
    dimension = before.shape[2]
    arrows, turned = before[1:].reshape(-1, dimension), after[1:].reshape(-1, dimension)
    lengths = np.abs(np.linalg.norm(arrows, axis=1) - np.linalg.norm(turned, axis=1))
    return Evidence(
        float(np.abs(here - there).max(initial=0.0)),
        float(lengths.max(initial=0.0)),
        _unevenness(arrows, turned, mirrored=gauge.mirrored),
    )


def _unevenness(arrows: Floats, turned: Floats, *, mirrored: bool) -> float:
    """Between all arrows on the floor: each is turned by the same angle, a mirrored one after it was mirrored."""
    directed = np.hypot(arrows[:, 0], arrows[:, 1]) > 0
    x, y = arrows[directed, 0], arrows[directed, 1]
    turns = np.arctan2(turned[directed, 1], turned[directed, 0]) - np.arctan2(y, -x if mirrored else x)
    if not len(turns):
        return 0.0
    # Turns of nearly 0 and nearly 360 degrees are the same.
    apart = (DEGREES * (turns - turns[0]) + 540.0) % 360.0 - 180.0
    return float(np.abs(apart).max())


def _distances(coefficients: Floats, times: Sequence[float]) -> Floats:
    places = RelativeKinematics(coefficients).positions(times)
    return np.asarray(np.linalg.norm(places[:, :, None] - places[:, None, :], axis=-1))


def _cosine_and_sine(degrees: float) -> tuple[float, float]:
    quarters = (degrees / 90.0) % 4.0
    if quarters.is_integer():
        return QUARTERS[int(quarters)]
    return float(np.cos(degrees / DEGREES)), float(np.sin(degrees / DEGREES))


def _fits(hint: dict[str, Any], dimension: int) -> bool:
    return _is_number(hint.get("degrees")) and all(_is_vector(hint.get(key), dimension) for key in ("shift", "pivot"))


def _is_vector(value: Any, dimension: int) -> bool:
    return isinstance(value, list) and len(value) == dimension and all(_is_number(each) for each in value)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and bool(np.isfinite(value))
