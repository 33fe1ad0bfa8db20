"""Fans of the axes: they hold 95 % of the directions that a covariance allows."""

import numpy as np
import pytest
from rangelab import IndoorScenario, Scenario
from rangelab.view import shapes
from rangelab.view.fans import fan_around
from viewer_client import until
from viewer_labs import shown


def test_a_ring_holds_95_percent_of_the_directions() -> None:
    numbers = np.random.default_rng(3)
    root = 0.02 * numbers.normal(size=(3, 3))
    axis = np.array([0.6, -0.48, 0.64])
    ring = fan_around(axis, root @ root.T)
    assert np.allclose(np.linalg.norm(ring, axis=1), 1.0)
    tips = np.cross(numbers.normal(size=(20_000, 3)) @ root.T, axis)
    # Inside: nearer to the axis than the ring is in the same direction, by the ellipse through three of its points.
    plane = np.linalg.svd(axis[None])[2][1:]
    edge = (ring - np.outer(ring @ axis, axis)) @ plane.T
    quadratic = np.stack([edge[:, 0] ** 2, 2 * edge[:, 0] * edge[:, 1], edge[:, 1] ** 2], axis=1)
    a, b, c = np.linalg.lstsq(quadratic, np.ones(len(edge)), rcond=None)[0]
    x, y = (tips @ plane.T).T
    share = np.mean(a * x**2 + 2 * b * x * y + c * y**2 <= 1)
    assert abs(share - 0.95) < 4 * np.sqrt(0.95 * 0.05 / len(tips)) + 0.002


def test_an_arc_reaches_1_96_standard_deviations() -> None:
    arc = fan_around(np.array([1.0, 0.0, 0.0]), np.array([[0.05**2]]))
    assert np.allclose(np.arctan2(arc[[0, -1], 1], arc[[0, -1], 0]), [-1.96 * 0.05, 1.96 * 0.05], rtol=1e-4)
    assert len(fan_around(np.array([1.0, 0.0, 0.0]), np.array([[np.nan]]))) == 0
    assert len(shapes.path(arc)) == len(arc) - 1


@pytest.mark.parametrize(
    ("scenario", "names"),
    [
        (Scenario.preset("room").replace(steps=5), {"/fans/bound/0", "/fans/uc-kf/2"}),
        (IndoorScenario.preset("indoor-u"), {"/fans/mekf/0"}),
        (Scenario.preset("planar").replace(steps=5), {"/fans/bound/1", "/fans/eskf/0"}),
    ],
)
def test_fans_are_switched_on(scenario: Scenario | IndoorScenario, names: set[str]) -> None:
    with shown(scenario) as (_, client):
        client.set(client.control("fans of the axes, 95 %"), True)
        until(lambda: names <= {message["name"] for message in client.of_type("LineSegmentsMessage")})
