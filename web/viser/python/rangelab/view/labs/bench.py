"""The body on a bench beside the room: in its own frame, so large that its sensors can be dragged."""

from dataclasses import dataclass

import numpy as np

from ...arrays import Floats
from .. import shapes
from ..canvas import Canvas
from ..picture import Change, Handle
from .size_curve import size_of

HALF, GAP = 0.3, 0.12
"""Half the edge of the bench, and its distance from the room, beside the longest side of the room."""
STEPS = 20
"""Sensors are dragged by a power of ten that is at most this part of the body."""
SMALLEST = 0.1
"""A single sensor is shown as if the body had this radius, m."""


def sensor_step(sensors: Floats) -> float:
    """What sensors are dragged by, m."""
    return float(10.0 ** np.floor(np.log10((size_of(sensors) or 0.2) / STEPS)))


@dataclass(frozen=True)
class Bench:
    """Where it stands, which depends on the anchors alone, and how many times as large the body is there."""

    centre: Floats
    """Of the body's frame, m: 3."""
    half: float
    """Half its edge, m."""
    times: float

    @classmethod
    def of(cls, anchors: Floats, sensors: Floats) -> "Bench":
        """At the right of the room."""
        points = shapes.lifted(anchors)
        low, high = points.min(axis=0), points.max(axis=0)
        extent = float((high - low).max()) or 1.0
        half = HALF * extent
        centre = np.array([high[0] + GAP * extent + half, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2])
        radius = float(np.linalg.norm(sensors, axis=1).max()) or SMALLEST
        # Grows in steps of the root of two, so that small changes of the body do not change the scale.
        reach = 1.1 * 2.0 ** (np.ceil(2 * np.log2(radius) - 1e-9) / 2)
        return cls(centre, half, half / reach)

    def places(self, sensors: Floats) -> Floats:
        """Where sensors (N x D, m) are drawn: N x 3."""
        return np.asarray(self.centre + self.times * shapes.lifted(sensors))

    def corners(self, *, flat: bool) -> Floats:
        """Of what the bench takes up, m: P x 3."""
        signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in ((0,) if flat else (-1, 1))])
        return np.asarray(self.centre + self.half * signs)

    def handles(self, sensors: Floats) -> list[Handle]:
        """The sensors."""
        places = self.places(sensors)[:, : sensors.shape[1]]
        return [self._handle(n, sensors, place) for n, place in enumerate(places)]

    def draw(self, canvas: Canvas, sensors: Floats, mounting_sigma: float) -> None:
        """A frame, the body's axes and edges, and balls where sensors may sit."""
        d = sensors.shape[1]
        corners, _, edges = shapes.box(*(self.centre + sign * self.half for sign in (-1, 1)), flat=True)
        if d == 2:
            corners[:, 2] = self.centre[2]
        canvas.lines("/bench/frame", corners[edges], "ink-soft", 1.5)
        tips = self.centre + self.half * np.eye(3)[:d]
        canvas.lines("/bench/axes", np.stack([np.tile(self.centre, (d, 1)), tips], axis=1), "ink-soft", 1.0)
        for axis, letter in zip("xyz", self.centre + 1.1 * (tips - self.centre), strict=False):
            canvas.label(f"/bench/{axis}", axis, letter, centred=True)
        canvas.label("/bench/name", f"body, {self.times:.3g} times as large", corners[0])
        places = self.places(sensors)
        canvas.lines("/bench/body", shapes.frame(sensors, places), "truth", 2.5)
        if mounting_sigma > 0:
            covariance = (mounting_sigma * self.times) ** 2 * np.eye(d)
            for n, place in enumerate(places):
                canvas.ellipsoid(f"/bench/cloud/{n}", covariance, place, 1.0, "accent")

    def _handle(self, n: int, sensors: Floats, place: Floats) -> Handle:
        step, before = sensor_step(sensors), sensors[n]

        def moved(to: Floats, _: Floats) -> Change:
            shift = (to - place) / self.times
            # What is not moved keeps its last digit.
            at = np.where(np.abs(shift) < 1e-6 * step, before, np.round((before + shift) / step) * step)
            return lambda scenario: scenario.replace({f"sensors[{n}]": [float(f"{value:.9g}") for value in at]})

        return Handle(f"/bench/sensor/{n}", f"S{n + 1}", place, moved, token="truth", size=0.4)
