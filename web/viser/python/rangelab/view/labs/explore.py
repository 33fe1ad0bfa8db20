"""What one moment's ranges show of the pose that the body starts in, and what they hide; the bound as a landscape."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..._core import Error
from ...arrays import Floats
from ...field import Field
from ...scenario import Scenario
from .. import shapes
from ..canvas import Canvas
from ..looks import Look
from ..picture import Handle, Wish
from ..plots import Plot
from ..readout import Row, Table
from . import drawing
from .bench import Bench
from .field_told import field_sentence
from .findings import as_sentence
from .ghost import Motion, motion_of
from .obstacles import obstacle_handles
from .probe import probed
from .room import advice_of, draw_room, field_of
from .size_curve import SizeCurves
from .track import anchor_handles

ROUNDED = 1e-12
"""Singular values below this share of the largest are zero but for rounding."""
BODY, PROBE = Look("body", "truth"), Look("read at", "accent", "cross")
ANCHORS, SENSORS = Look("centred anchors, m", "anchor", "square"), Look("[C; 1] of the sensors", "anchor", "diamond")


@dataclass
class ExplorePicture:
    """The bounds at the start, why they are no better, and the field where it is wished for."""

    wish: Wish
    run: dict[str, Any]
    """The crate's `Exploration`."""
    document: dict[str, Any]
    scenario: Scenario
    sizes: SizeCurves
    field: Field | None
    advice: dict[str, Any] | None
    """As in the lab Track."""
    reading: dict[str, Any] | None
    """The crate's `PointBound` at the place that is read."""

    @property
    def name(self) -> str:
        """What people call it."""
        return str(self.document["name"])

    @property
    def times(self) -> Floats:
        """One moment."""
        return np.zeros(1)

    @property
    def outline(self) -> Floats:
        """Anchors, the body, and the bench beside them."""
        corners = self.bench.corners(flat=self.scenario.dimension == 2)
        return np.concatenate([shapes.lifted(self._room), corners])

    @property
    def magnification(self) -> float:
        """So that the ellipsoid of the bound is seen."""
        sigma = self.run["position_sigma"]
        return min(10.0, drawing.magnification([np.array([sigma or 0.0])], drawing.extent_of(self._room)))

    @property
    def bench(self) -> Bench:
        """Where the body is designed."""
        return Bench.of(self.scenario.anchors, self.scenario.sensors)

    @property
    def motion(self) -> Motion | None:
        """The motion that is seen least, as it is drawn."""
        if not self.run["modes"]:
            return None
        radius = float(np.linalg.norm(self.scenario.sensors, axis=1).max())
        return motion_of(self.run["modes"][0], radius, drawing.extent_of(self._room) / 4 / self._scale)

    @property
    def _room(self) -> Floats:
        return np.array([*self.document["anchors"], self.document["start"]["position"]])

    @property
    def _scale(self) -> float:
        return drawing.body_scale(self.scenario.sensors, drawing.extent_of(self._room), drawing.ALONE)

    def sentences(self) -> list[str]:
        """What is hidden and by what, what is drawn, and what the colours of the field mean."""
        told = [as_sentence(self.run["sentence"])]
        if self.run["twin"] is not None:
            told.append(f"{as_sentence(self.run['twin']['sentence'])} It is drawn dashed.")
        if self.motion is not None:
            told.append(self.motion.sentence)
        available = np.array(self.run["available"])
        if not available.all():
            told.append(f"{(~available).sum()} of {available.size} ranges cannot be measured: dashed.")
        if self.field is not None:
            told.append(field_sentence(self.field, self.document))
        return [*filter(None, told), *drawing.scale_sentence(self._scale)]

    def handles(self) -> list[Handle]:
        """Anchors, the body, obstacles, and the sensors on the bench."""
        sensors = self.bench.handles(self.scenario.sensors)
        room = drawing.around_the_body(anchor_handles(self.document))
        # No larger than in labs without the bench.
        share = drawing.extent_of(self._room) / drawing.extent_of(self.outline)
        every = [*room, *obstacle_handles(self.document), *sensors]
        return [replace(handle, size=share * handle.size) for handle in every]

    def plots(self) -> list[Plot]:
        """How large the body must be."""
        return [self.sizes.plot()]

    def readout(self, step: int) -> Table:
        """The bounds of one epoch, and how anchors and sensors are spread."""
        rows = [Row(BODY, _bounds(self.run))]
        if self.reading is not None:
            rows.append(Row(PROBE, _bounds(self.reading)))
        for look, key in ((ANCHORS, "anchor_singular_values"), (SENSORS, "sensor_singular_values")):
            values = self.run[key]
            rows.append(Row(look, tuple(0.0 if each < ROUNDED * values[0] else each for each in values), first=2))
        most = max(len(self.run["anchor_singular_values"]), len(self.run["sensor_singular_values"]))
        groups = (
            ("bound of one epoch", ("orient.\ndeg", "position\nm")),
            ("singular values", tuple(f"{number}." for number in range(1, most + 1))),
        )
        return Table(groups, tuple(rows))

    def draw(self, canvas: Canvas, step: int, magnify: float) -> None:
        """The body with its bounds, ghost and twin, ranges, what is in the way, the field, and the bench."""
        canvas.unit = drawing.extent_of(self._room)
        place, turned = (np.array(self.document["start"][key]) for key in ("position", "orientation"))
        sensors = self._scale * self.scenario.sensors
        corners = shapes.lifted(shapes.body(turned, place, sensors))
        canvas.lines("/truth/body", shapes.frame(sensors, corners), "truth", 3.0)
        self._draw_ranges(canvas, corners)
        self._draw_bounds(canvas, place, turned, magnify)
        self._draw_hidden(canvas, place, turned, corners)
        draw_room(canvas, self.document, self._room, self.field, self.advice)
        self.bench.draw(canvas, self.scenario.sensors, self.document["mounting_sigma"])

    def _draw_ranges(self, canvas: Canvas, corners: Floats) -> None:
        """A line for each range, dashed where it cannot be measured."""
        available = np.array(self.run["available"])
        drawing.draw_ranges(canvas, self.scenario.anchors, corners, available)
        missing = shapes.between(self.scenario.anchors, corners, ~available)
        canvas.lines("/ranges/missing", shapes.dashed(shapes.divided(missing, 36), 1, 2), "range", 1.0)

    def _draw_bounds(self, canvas: Canvas, place: Floats, turned: Floats, magnify: float) -> None:
        """The ellipsoid of the position, here and where the field is read, and fans of the axes."""
        if self.run["position_covariance"] is not None:
            canvas.ellipsoid("/bound/position", np.array(self.run["position_covariance"]), place, magnify, "bound")
        if self.wish.fans and self.run["rotation_covariance_in_world"] is not None:
            turns = np.array(self.run["rotation_covariance_in_world"])
            drawing.draw_fans(canvas, "bound", "bound", turned, turns, place)
        probe = probed(self.wish)
        if probe is None:
            return
        there = np.array(probe)
        canvas.marks("/probe/mark", shapes.lifted(there[None]), PROBE, 1.5)
        covariance = (self.reading or {}).get("position_covariance")
        if covariance is not None and self.document["field"]["subject"] == "body":
            canvas.ellipsoid("/probe/position", np.array(covariance), there, magnify, "accent")

    def _draw_hidden(self, canvas: Canvas, place: Floats, turned: Floats, corners: Floats) -> None:
        """The body moved along the motion that is seen least, to both sides, and its twin with the same ranges."""
        body = self.scenario.sensors
        if self.motion is not None:
            motion = Motion(self.motion.rotation, self._scale * self.motion.shift, self.motion.times)
            sides = [motion.moved(turned, place, self._scale * body, sign) for sign in (1.0, -1.0)]
            canvas.lines("/ghost/there", shapes.frame(body, sides[0]), "accent", 2.0)
            canvas.lines("/ghost/back", shapes.dashed(shapes.divided(shapes.frame(body, sides[1]), 12)), "accent", 1.5)
            canvas.lines("/ghost/ways", np.stack([corners, sides[0]], axis=1), "accent", 1.0)
        if self.run["twin"] is not None:
            twin = shapes.lifted(np.array(self.run["twin"]["sensors"]))
            drawn = twin.mean(axis=0) + self._scale * (twin - twin.mean(axis=0))
            canvas.lines("/twin/body", shapes.dashed(shapes.divided(shapes.frame(body, drawn), 12)), "warning", 2.5)
            canvas.marks("/twin/sensors", drawn, Look("twin", "warning", "ring"))


def explore(wish: Wish) -> ExplorePicture:
    """Runs the crate.

    Raises:
        Error: in a sentence.
    """
    source = wish.source
    assert isinstance(source, Scenario)
    document, probe = source.to_dict(), probed(wish)
    return ExplorePicture(
        wish,
        source.explore(),
        document,
        source,
        SizeCurves.of(source),
        field_of(wish, source),
        advice_of(wish, source),
        None if probe is None else _read(source, probe),
    )


def _read(scenario: Scenario, place: tuple[float, ...]) -> dict[str, Any] | None:
    """The bound at a place; nothing where the crate has none to tell, as at an anchor."""
    try:
        return scenario.bound_at(place)
    except Error:
        return None


def _bounds(found: dict[str, Any]) -> tuple[float, float]:
    angle, position = (np.nan if found[key] is None else found[key] for key in ("angle_sigma", "position_sigma"))
    return float(np.degrees(angle)), float(position)
