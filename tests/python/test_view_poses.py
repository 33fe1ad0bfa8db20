"""Typed orientations and typed way points in the viewer."""

from typing import Any

import numpy as np
import pytest
from rangelab import Scenario
from rangelab.view import Viewer
from rangelab.view.labs.orientation import angles_of, rotation_of
from viewer_client import until
from viewer_labs import shown

ROOM = Scenario.preset("room").replace(steps=10)


def document(viewer: Viewer) -> dict[str, Any]:
    source = viewer.shown.wish.source
    assert isinstance(source, Scenario)
    return source.to_dict()


@pytest.mark.parametrize("angles", [[30.0], [-120.0], [10.0, -50.0, 170.0], [-170.0, 89.0, 3.0], [0.0, 90.0, 25.0]])
def test_angles_are_rotations_and_back(angles: list[float]) -> None:
    rotation = rotation_of(angles)
    assert np.allclose(rotation @ rotation.T, np.eye(len(rotation)), atol=1e-14)
    assert np.isclose(np.linalg.det(rotation), 1.0)
    assert np.allclose(angles_of(rotation), angles, atol=1e-9)


def test_yaw_turns_about_z_and_roll_about_x() -> None:
    assert np.allclose(rotation_of([0, 0, 90]) @ [1, 0, 0], [0, 1, 0])
    assert np.allclose(rotation_of([90, 0, 0]) @ [0, 1, 0], [0, 0, 1])
    assert np.allclose(rotation_of([0, 90, 0]) @ [0, 0, 1], [1, 0, 0])
    assert np.allclose(rotation_of([90, 0, 90]) @ [0, 1, 0], [0, 0, 1])


def test_orientations_of_the_start_and_of_the_guess_are_typed() -> None:
    with shown(ROOM) as (viewer, client):
        client.set(client.control("guessed orientation, deg"), (0.0, 0.0, 90.0))
        until(lambda: document(viewer)["initial"]["orientation"] != ROOM.to_dict()["initial"]["orientation"])
        assert np.allclose(document(viewer)["initial"]["orientation"], [[0, -1, 0], [1, 0, 0], [0, 0, 1]])
        client.set(client.control("orientation, deg"), (0.0, 0.0, 45.0))
        until(lambda: np.allclose(document(viewer)["start"]["orientation"], rotation_of([0, 0, 45])))
        source = viewer.shown.wish.source
        assert isinstance(source, Scenario)
        assert viewer.shown.run.to_json() == source.run().to_json()


def test_way_points_are_typed_added_and_removed_and_the_path_is_closed() -> None:
    points = [[2.0, 1.0, 1.0], [3.0, 2.0, 1.0], [4.0, 2.0, 1.0]]
    path = {"kind": "drawn", "points": points, "closed": False, "period": 2.0}
    drawn = ROOM.replace({"motion.path": path})

    with shown(drawn) as (viewer, client):

        def now() -> list[list[float]]:
            found: list[list[float]] = document(viewer)["motion"]["path"]["points"]
            return found

        client.set(client.control("way point"), "2")
        client.set(client.control("way point, m"), (3.0, 3.0, 1.5))
        until(lambda: now()[1] == [3.0, 3.0, 1.5])
        client.press("Add a way point after it")
        until(lambda: len(now()) == 4)
        assert now()[2] == [3.5, 2.5, 1.25]
        client.press("Remove the way point")
        until(lambda: now() == [points[0], [3.5, 2.5, 1.25], points[2]])
        client.set(client.control("closed: back to the start, and again"), True)
        until(lambda: document(viewer)["motion"]["path"]["closed"])
