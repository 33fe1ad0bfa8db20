"""Nodes without anchors in the viewer: what distances cannot see, and the ellipsoids of the bound."""

from unittest.mock import MagicMock

import numpy as np
from rangelab import KinematicsScenario
from rangelab.view.labs import computed
from rangelab.view.labs.gauge import mirrored, shifted, turned
from rangelab.view.picture import Wish
from viewer_client import until
from viewer_labs import shown

FOUR = KinematicsScenario.preset("kinematics-four")


def distances(scenario: KinematicsScenario) -> np.ndarray:
    places = scenario.motion.positions(np.linspace(-1.0, 2.0, 5))
    return np.asarray(np.linalg.norm(places[:, :, None] - places[:, None, :], axis=-1))


def test_turns_mirrors_and_shifts_change_no_distance() -> None:
    places = np.array(FOUR.to_dict()["coefficients"][0])
    way = np.full(places.shape[1], 3.0)
    for change in (turned(40.0), mirrored, shifted(way)):
        moved = change(FOUR)
        assert isinstance(moved, KinematicsScenario)
        assert not np.allclose(moved.to_dict()["coefficients"][0], places)
        assert np.allclose(distances(moved), distances(FOUR), rtol=1e-12)
        assert np.isclose(moved.bound().coefficient_rmse(0), FOUR.bound().coefficient_rmse(0), rtol=1e-6)
    quarter = np.array(turned(90.0)(FOUR).to_dict()["coefficients"])
    velocities = np.array(FOUR.to_dict()["coefficients"][1])
    assert np.allclose(quarter[1, :, 0], -velocities[:, 1])
    assert np.allclose(quarter[0].mean(axis=0), places.mean(axis=0))


def test_the_network_is_turned_and_shifted_by_buttons() -> None:
    with shown(FOUR) as (viewer, client):
        client.set(client.control("turn by, deg"), 90.0)
        client.press("Turn all nodes")
        until(lambda: viewer.shown.wish.source == turned(90.0)(FOUR))
        client.press("Mirror all nodes")
        until(lambda: viewer.shown.wish.source == mirrored(turned(90.0)(FOUR)))
        client.set(client.control("edits"), "undo")
        until(lambda: viewer.shown.wish.source == turned(90.0)(FOUR))


def test_the_ellipsoids_are_those_of_the_bound() -> None:
    picture, canvas = computed(Wish(FOUR, "anchorless")), MagicMock(unit=1.0)
    picture.draw(canvas, 3, 20.0)
    drawn = {call.args[0]: call.args[1:] for call in canvas.ellipsoid.call_args_list}
    senses = "accelerometers" in picture.bounds  # type: ignore[attr-defined]
    time = picture.times[3]
    covariance = FOUR.bound(senses).position_covariance(time)
    places = FOUR.motion.positions(time)[0]
    dimension = places.shape[1]
    for n, place in enumerate(places):
        block = slice(n * dimension, (n + 1) * dimension)
        found, centre, scale, token = drawn[f"/bound/{n}"]
        assert np.array_equal(found, covariance[block, block])
        assert (np.array_equal(centre, place), scale, token) == (True, 20.0, "bound")
