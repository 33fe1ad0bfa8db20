"""Placement in the viewer: boxes, arrows by the crate's slopes, and how far the best found is."""

import threading
import time
from typing import Any

import numpy as np
from rangelab import Scenario
from rangelab.view import Viewer
from rangelab.view.labs.placement_boxes import downhill
from viewer_client import ViewerClient, until
from viewer_labs import shown

ROOM = Scenario.preset("room").replace(steps=10)


def placement(viewer: Viewer) -> dict[str, Any]:
    source = viewer.shown.wish.source
    assert isinstance(source, Scenario)
    found: dict[str, Any] = source.to_dict()["placement"]
    return found


def lines(client: ViewerClient) -> set[str]:
    return {message["name"] for message in client.of_type("LineSegmentsMessage")}


def test_boxes_are_added_typed_drawn_and_taken_away() -> None:
    with shown(ROOM) as (viewer, client):
        client.set(client.control("the body is within"), True)
        until(lambda: placement(viewer)["region"])
        body, reach = np.array(ROOM.to_dict()["start"]["position"]), np.ptp(ROOM.anchors, axis=0) / 4
        assert np.allclose(placement(viewer)["region"]["low"], body - reach, rtol=1e-2)
        client.set(client.control("anchors stand within"), True)
        until(lambda: placement(viewer)["limits"])
        assert placement(viewer)["limits"]["high"] == ROOM.anchors.max(axis=0).tolist()
        client.press("Add a keep-out box")
        until(lambda: placement(viewer)["keep_out"])
        until(lambda: {"/placement/region", "/placement/limits", "/placement/keep-out-0"} <= lines(client))
        client.press("Remove the keep-out box")
        until(lambda: not placement(viewer)["keep_out"])
        client.set(client.control("the body is within"), False)
        until(lambda: placement(viewer)["region"] is None)


def test_a_ceiling_that_is_typed_holds_anchors_down() -> None:
    planar = Scenario.preset("room").replace(
        {"placement.limits": {"low": [0, 0, 0], "high": [6, 5, 1.5]}, "placement.fixed": []}
    )
    with shown(planar) as (viewer, client):
        client.set(client.control("searches"), 1)
        client.press("Improve, or cancel")
        until(lambda: "Improved from" in str(client.of_type("GuiUpdateMessage")))
        until(lambda: viewer.shown.wish.source != planar)
        assert viewer.shown.run.anchors[:, 2].max() <= 1.5 + 1e-12


def test_arrows_point_against_the_slope_that_the_crate_gives() -> None:
    gradient = np.array(ROOM.advise()["gradient"])
    ways = downhill(gradient, [0])
    assert np.isnan(ways[0]).all()
    assert np.isclose(np.nanmax(np.linalg.norm(ways, axis=1)), 1.0)
    steepest = int(np.nanargmax(np.linalg.norm(ways, axis=1)))
    step = 1e-4 * ways[steepest]
    moved = ROOM.replace({f"anchors[{steepest}]": ROOM.anchors[steepest] + step})
    slope = (moved.advise()["value"] - ROOM.advise()["value"]) / 1e-4
    assert np.isclose(slope, -np.linalg.norm(gradient[steepest]), rtol=1e-2)
    with shown(ROOM) as (viewer, client):
        client.set(client.control("arrows to better places"), True)
        until(lambda: "/placement/arrows" in lines(client))
        assert viewer.shown.advice == ROOM.advise()  # type: ignore[attr-defined]


def test_the_best_found_is_told_in_per_cent() -> None:
    with shown(ROOM) as (viewer, client):

        def told() -> str:
            return str(client.of_type("GuiUpdateMessage"))

        client.set(client.control("searches"), 1)
        client.press("Improve, or cancel")
        until(lambda: "You are at the best found." in told())
        best = viewer.shown.wish.source
        assert isinstance(best, Scenario)
        worse = best.replace({"anchors[0]": [3.0, 2.0, 1.0]})
        client.drag("/anchors/0", (3.0, 2.0, 1.0))
        share = 100 * best.advise()["value"] / worse.advise()["value"]
        until(lambda: f"You are at {share:.0f} % of the best found." in told())


SLOW = ROOM.replace(
    {
        "anchors": np.concatenate(
            [ROOM.anchors, *(ROOM.anchors + np.array(way) for way in ([0.3, 0.2, 0.1], [-0.1, -0.2, -0.3]))]
        ),
        "field.headings": 72,
        "placement.region": {"low": [1, 1, 0.5], "high": [4, 4, 2]},
    }
)
"""Its 64 searches take minutes, each of them seconds."""


def searches() -> list[str]:
    return [thread.name for thread in threading.enumerate() if thread.name.startswith("rangelab-place")]


def begun(client: ViewerClient) -> None:
    client.set(client.control("searches"), 64)
    client.press("Improve, or cancel")
    until(searches)


def test_a_search_ends_with_the_viewer() -> None:
    with shown(SLOW) as (viewer, client):
        begun(client)
        began = time.monotonic()
        viewer.stop()
        assert not searches()
        assert time.monotonic() - began < 20


def test_a_search_ends_where_the_scene_or_the_lab_changes() -> None:
    with shown(SLOW) as (viewer, client):
        begun(client)
        client.set(client.control("seed"), 5)
        until(lambda: not searches(), seconds=20)
        until(lambda: "The scene has changed: the search was stopped." in str(client.of_type("GuiUpdateMessage")))
        changed = SLOW.replace(seed=5)
        assert viewer.shown.wish.source == changed
        begun(client)
        client.set(client.control("shown as"), "Localize")
        until(lambda: not searches(), seconds=20)
        until(lambda: viewer.shown.wish.lab == "localize")
        assert viewer.shown.wish.source == changed
