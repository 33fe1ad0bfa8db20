"""What the labs draw alike: the truth, the body, what estimators found of it."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Protocol

import numpy as np

from ...arrays import Flags, Floats
from ...reports import PosePart
from ...studies import Curve
from .. import shapes
from ..canvas import Canvas
from ..fans import fan_around
from ..looks import Look
from ..picture import Handle
from ..plots import Line
from ..readout import root_mean_square


class Stopped(Protocol):
    """What may have failed: from which step on, and why."""

    failure: tuple[int, str] | None


LARGEST_ERROR = 0.08
"""Share of the scene that the largest error is drawn as, at most."""
VISIBLE_SHARE, DRAWN_SHARE = 0.08, 0.15
"""A body smaller than the first share of the scene is too small to see and is drawn as large as the second."""
ALONE, AROUND = 0.3, 1.9
"""As large as this share a body is drawn that is all there is to see, with handles so many times as large around it."""
FAN = 0.08
"""How far the axes of fans reach beside the scene."""
WIDEST_RIM = 3.0
"""How much wider than the last the first of many tracks is drawn, pixels."""


def magnification(errors: list[Floats], extent: float, share: float = LARGEST_ERROR) -> float:
    """How many times larger errors are drawn, a round number, so that the largest is seen; at least 1."""
    known = [each[np.isfinite(each)] for each in errors]
    largest = max((float(each.max()) for each in known if len(each)), default=0.0)
    if largest <= 0:
        return 1.0
    return round_times(share * extent / largest)


def round_times(wanted: float) -> float:
    """The largest round number, 1, 2 or 5 times a power of ten, that is no more than the wanted one; at least 1."""
    decade = 10.0 ** np.floor(np.log10(wanted))
    return max(1.0, float(max(n * decade for n in (1, 2, 5) if n * decade <= wanted)))


def body_scale(sensors: Floats, extent: float, drawn: float = DRAWN_SHARE) -> float:
    """How many times as large a body (N x D, m) is drawn, so that it is seen in a scene of this extent; at least 1."""
    radius = max(float(np.linalg.norm(sensors, axis=1).max()), 1e-9)
    share = radius / (extent / 2)
    return 1.0 if share >= VISIBLE_SHARE else float(np.floor(drawn / share))


def around_the_body(handles: list[Handle]) -> list[Handle]:
    """Handles, those of a body that is drawn large around it."""
    return [replace(each, size=AROUND) if each.orientation is not None else each for each in handles]


def scale_sentence(scale: float) -> list[str]:
    """That a body is drawn larger than it is."""
    return [] if scale == 1.0 else [f"The body is drawn {scale:.0f} times as large as it is."]


def extent_of(points: Floats) -> float:
    """The longest edge of the box around points (P x D), m."""
    return float(np.ptp(shapes.known(points), axis=0).max()) or 1.0


def draw_truth(canvas: Canvas, orientations: Floats, positions: Floats, sensors: Floats, step: int) -> None:
    """The true track (K x D), heavier up to the step, and the body at it."""
    canvas.lines("/truth/past", shapes.path(positions[: step + 1]), "truth", 4.0)
    canvas.lines("/truth/path", shapes.path(positions), "truth", 1.5)
    corners = shapes.body(orientations[step], positions[step], sensors)
    canvas.lines("/truth/body", shapes.frame(sensors, corners), "truth", 3.0)


def draw_track(canvas: Canvas, name: str, look: Look, positions: Floats, step: int, rim: float) -> None:
    """An estimated track (K x D), magnified already; earlier estimators are wider by a rim, so that all are seen."""
    segments = shapes.path(positions)
    if look.dash:
        segments = shapes.dashed(segments)
    canvas.lines(f"/estimators/{name}/path", segments, look.token, 1.5 + rim)
    canvas.marks(f"/estimators/{name}/mark", shapes.lifted(positions[step : step + 1]), look, 1.0 + 0.25 * rim)


@dataclass(frozen=True)
class Manner:
    """How all estimates of a scene are drawn."""

    truth: Floats
    """Around these positions (K x D, m) errors are magnified."""
    body: Floats
    """The sensors as they are drawn, in the body frame, m: N x D."""
    magnify: float
    fans: bool
    """Whether with fans of the axes."""


def draw_estimate(canvas: Canvas, look: Look, estimate: PosePart[Any], step: int, rim: float, manner: Manner) -> Floats:
    """Its track, and at a step the body and the ellipsoid of its position; gives the positions as drawn, K x D."""
    name, magnify = estimate.name, manner.magnify
    positions = shapes.magnified(estimate.positions, manner.truth, magnify)
    draw_track(canvas, name, look, positions, step, rim)
    if np.isfinite(positions[step]).all():
        corners = shapes.body(estimate.orientations[step], positions[step], manner.body)
        canvas.lines(f"/estimators/{name}/body", shapes.frame(manner.body, corners), look.token, 2.0)
        covariance = estimate.position_covariances[step]
        canvas.ellipsoid(f"/estimators/{name}/ellipsoid", covariance, positions[step], magnify, look.token)
        if manner.fans:
            turns = estimate.rotation_covariances[step]
            draw_fans(canvas, name, look.token, estimate.orientations[step], turns, positions[step])
    return positions


def draw_fans(canvas: Canvas, name: str, token: str, orientation: Floats, covariance: Floats, centre: Floats) -> None:
    """The 95 % fans of the body's axes about a centre (D, m), by the covariance of an orientation."""
    if not (np.isfinite(orientation).all() and np.isfinite(centre).all()):
        return
    reach, middle = FAN * canvas.unit, shapes.lifted(centre)
    for i, column in enumerate(shapes.lifted(orientation.T)):
        axis = column / np.linalg.norm(column)
        ring = middle + reach * fan_around(axis, covariance)
        if len(ring):
            spoke = np.array([[middle, middle + reach * axis]])
            canvas.lines(f"/fans/{name}/{i}", np.concatenate([shapes.path(ring), spoke]), token, 1.5)


def draw_ranges(canvas: Canvas, anchors: Floats, sensors: Floats, present: Flags) -> None:
    """A line for each range (M x N) that was measured."""
    canvas.lines("/ranges", shapes.between(anchors, sensors, present), "range", 1.0)


def rims(count: int) -> list[float]:
    """How much wider each of several tracks is drawn than the last, pixels."""
    each = min(0.6, WIDEST_RIM / max(count - 1, 1))
    return [each * (count - 1 - index) for index in range(count)]


def lines_of(looks: dict[str, Look], values: dict[str, Floats], factor: float = 1.0) -> tuple[Line, ...]:
    """A line for each estimator that has numbers."""
    shown = {name: factor * each for name, each in values.items() if np.isfinite(each).any()}
    widths = rims(len(shown))
    return tuple(Line(looks[name], each, 1.5 + rim) for (name, each), rim in zip(shown.items(), widths, strict=True))


def banded(looks: dict[str, Look], curves: Mapping[str, Curve]) -> tuple[Line, ...]:
    """Lines of averages, with a band of two standard errors on either side."""
    plain = lines_of(looks, {name: curve.values for name, curve in curves.items()})
    errors = {looks[name]: curve.standard_errors for name, curve in curves.items()}
    return tuple(replace(line, spread=2 * errors[line.look]) for line in plain)


def readings(angles: Floats, positions: Floats, step: int) -> tuple[float, float, float, float]:
    """Angle (deg) and position (m) at a step, and root mean squares over the run."""
    degrees = float(np.degrees(1.0))
    overall = degrees * root_mean_square(angles), root_mean_square(positions)
    return degrees * float(angles[step]), float(positions[step]), *overall


def ended(part: Stopped, step: int) -> str:
    """That an estimator had stopped before a step; nothing where it runs."""
    if part.failure is None or step < part.failure[0]:
        return ""
    return f"stopped at step {part.failure[0] + 1}"
