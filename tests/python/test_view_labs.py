"""The labs of the viewer by its protocol: controls and handles edit the document, and the crate computes it."""

from functools import partial
from typing import Any

import numpy as np
import pytest
from rangelab import IndoorScenario, KinematicsScenario, Scenario
from rangelab.view import Viewer, shapes, themes
from rangelab.view.history import History
from rangelab.view.labs import LABS, lab_of
from rangelab.view.labs.obstacles import mesh_of
from viewer_client import ViewerClient, until
from viewer_labs import shown

ROOM = Scenario.preset("room")


def document(viewer: Viewer) -> dict[str, Any]:
    """The document of what is shown."""
    source = viewer.shown.wish.source
    assert not isinstance(source, type(ROOM.simulate()))
    return source.to_dict()


def named(client: ViewerClient, kind: str) -> set[str]:
    """The names of the scene's parts of one kind that were sent."""
    return {message["name"] for message in client.of_type(kind)}


def test_walls_and_boxes_are_added_dragged_changed_and_removed() -> None:
    with shown(ROOM) as (viewer, client):
        client.press("Add a wall")
        until(lambda: document(viewer)["availability"]["obstacles"])
        client.press("Add a box")
        until(lambda: len(document(viewer)["availability"]["obstacles"]) == 2)
        until(lambda: {"/obstacles/0/faces", "/obstacles/1/faces"} <= named(client, "MeshMessage"))
        until(lambda: "/obstacles/1/handle" in named(client, "TransformControlsMessage"))
        box = document(viewer)["availability"]["obstacles"][1]
        client.drag("/obstacles/1/handle", (1.0, 2.0, 1.5))
        until(lambda: document(viewer)["availability"]["obstacles"][1] != box)
        moved = document(viewer)["availability"]["obstacles"][1]
        low, high, was_low, was_high = (np.array(each[end]) for each in (moved, box) for end in ("low", "high"))
        assert np.allclose((low + high) / 2, [1.0, 2.0, 1.5])
        assert np.allclose(high - low, was_high - was_low)
        client.set(client.control("obstacle"), "Wall 1")
        client.press("Remove the obstacle")
        until(lambda: [each["kind"] for each in document(viewer)["availability"]["obstacles"]] == ["box"])
        source = viewer.shown.wish.source
        assert isinstance(source, Scenario)
        assert viewer.shown.run.to_json() == source.run().to_json() != ROOM.run().to_json()


def test_a_wall_without_an_end_goes_from_floor_to_ceiling() -> None:
    wall = {"kind": "wall", "from": [0.0, 1.0], "to": [2.0, 1.0], "bottom": None, "top": 1.5}
    vertices, faces, edges = mesh_of(wall, 3, (-1.0, 4.0))
    assert vertices[:, 2].tolist() == [-1.0, -1.0, 1.5, 1.5]
    assert (len(faces), len(edges)) == (2, 4)
    assert mesh_of(wall, 2, (0.0, 0.0))[0].tolist() == [[0.0, 1.0, 0.0], [2.0, 1.0, 0.0]]
    corners, faces, edges = shapes.box(np.zeros(3), np.array([1.0, 2.0, 3.0]), flat=False)
    sides = corners[faces]
    areas = np.linalg.norm(np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]), axis=1) / 2
    assert np.isclose(areas.sum(), 2 * (2 + 3 + 6))
    assert np.isclose(np.linalg.norm(np.diff(corners[edges], axis=1), axis=2).sum(), 4 * (1 + 2 + 3))


def test_paths_and_their_numbers_are_chosen() -> None:
    with shown(ROOM) as (viewer, client):
        client.set(client.control("path"), "turn")
        until(lambda: (document(viewer)["motion"]["path"] or {}).get("kind") == "turn")
        assert document(viewer)["motion"]["velocity"] == [0.0, 0.0, 0.0]
        client.set(client.control("radius, m"), 0.5)
        until(lambda: document(viewer)["motion"]["path"]["radius"] == 0.5)
        client.set(client.control("path"), "drawn by hand")
        until(lambda: document(viewer)["motion"]["path"]["kind"] == "drawn")
        until(lambda: "/way/3" in named(client, "TransformControlsMessage"))
        client.drag("/way/3", (2.0, 2.0, 1.0))
        until(lambda: document(viewer)["motion"]["path"]["points"][3] == [2.0, 2.0, 1.0])


def test_anchors_reach_stay_come_and_go() -> None:
    with shown(ROOM) as (viewer, client):
        client.set(client.control("anchor"), "A2")
        client.set(client.control("reaches, m"), True)
        until(lambda: document(viewer)["availability"]["max_ranges"] == [None, 5.0, None, None, None, None])
        client.set(client.control("stays where it is"), True)
        until(lambda: document(viewer)["placement"]["fixed"] == [1])
        client.press("Add an anchor")
        until(lambda: len(viewer.shown.run.anchors) == 7)


def test_improving_moves_the_free_anchors_to_better_places() -> None:
    scenario = Scenario.preset("planar").replace({"placement.fixed": [0]})
    with shown(scenario) as (viewer, client):
        client.set(client.control("searches"), 2)
        client.press("Improve, or cancel")
        until(lambda: "Improved from" in str(client.of_type("GuiUpdateMessage")))
        until(lambda: document(viewer)["anchors"] != scenario.to_dict()["anchors"])
        better = viewer.shown.wish.source
        assert isinstance(better, Scenario)
        assert better.advise()["value"] < scenario.advise()["value"]
        assert np.array_equal(better.anchors[0], scenario.anchors[0])
        client.press("Add the best next anchor")
        until(lambda: len(viewer.shown.run.anchors) == len(scenario.anchors) + 1)


def test_a_search_that_is_called_off_moves_nothing() -> None:
    # Of many headings, so that it is still under way when it is called off.
    slow = ROOM.replace({"field.headings": 36})
    with shown(slow) as (viewer, client):
        client.set(client.control("searches"), 64)
        client.press("Improve, or cancel")
        until(lambda: "of 64" in str(client.of_type("GuiUpdateMessage")))
        client.press("Improve, or cancel")
        until(lambda: "Cancelled: no anchor has moved." in str(client.of_type("GuiUpdateMessage")))
        assert viewer.shown.wish.source == slow


def test_a_drag_is_taken_back_and_made_again_as_one_edit() -> None:
    with shown(ROOM) as (viewer, client):
        client.drag("/anchors/1", (2.0, 1.0, 3.0))
        until(lambda: tuple(viewer.shown.run.anchors[1]) == (2.0, 1.0, 3.0))
        client.drag("/anchors/1", (3.0, 1.0, 3.0))
        until(lambda: tuple(viewer.shown.run.anchors[1]) == (3.0, 1.0, 3.0))

        def at(x: float) -> bool:
            return bool(viewer.shown.run.anchors[1][0] == x)

        for press, x in (("undo", 2.0), ("undo", ROOM.anchors[1][0]), ("redo", 2.0)):
            client.set(client.control("edits"), press)
            until(partial(at, x))


def test_a_history_joins_what_belongs_to_one_gesture() -> None:
    history = History(0)
    for state, gesture in ((1, "a"), (2, "a"), (3, "b"), (4, ""), (5, "")):
        history.edit(state, gesture)
    seen = [history.present]
    while history.undo():
        seen.append(history.present)
    assert seen == [5, 4, 3, 2, 0]
    assert history.redo()
    history.edit(7, "a")
    assert not history.redo()
    assert history.undo()
    assert history.present == 2


@pytest.mark.parametrize("theme", ["dark", "projector"])
def test_another_theme_colours_all_anew(theme: str) -> None:
    with shown(ROOM) as (viewer, client):
        client.set(client.control("theme"), theme)
        wanted = themes.THEMES[theme]
        until(lambda: any(m["dark_mode"] == wanted.dark for m in client.of_type("ThemeConfigurationMessage")[1:]))
        until(lambda: wanted.css("kf") in str(client.of_type("GuiUplotMessage")[-5:]))

        def ellipsoid() -> Any:
            sent = [m for m in client.of_type("MeshMessage") if m["name"] == "/estimators/kf/ellipsoid"]
            return sent[-1]["props"]["color"]

        until(lambda: tuple(ellipsoid()) == wanted.rgb("kf"))
        assert viewer.shown.wish.source == ROOM


def test_indoor_beacons_are_dragged_and_filters_computed_anew() -> None:
    scenario = IndoorScenario.preset("indoor-u")
    with shown(scenario) as (viewer, client):
        client.drag("/anchors/1", (6.0, 3.0, -1.0))
        expected = scenario.replace({"beacons[1]": [6.0, 3.0, -1.0]})
        until(lambda: viewer.shown.wish.source == expected)
        assert viewer.shown.run.to_json() == expected.run().to_json() != scenario.run().to_json()
        assert {"/estimators/mekf/ellipsoid", "/estimators/ekf-rie/ellipsoid"} <= named(client, "MeshMessage")
        titles = {message["props"]["title"] for message in client.of_type("GuiUplotMessage")}
        assert {"Position error, m", "Orientation error, deg", "NEES / dof"} <= titles
        client.set(client.control("samples are"), "mean")
        client.set(client.control("range σ, m"), 0.2)
        until(lambda: document(viewer)["ranging"]["sigma"] == 0.2)
        assert document(viewer)["imu"]["convention"] == "mean"
        client.set(client.control("path"), "over a bridge")
        until(lambda: document(viewer)["path"] == "bridge")
        assert document(viewer)["beacons"] == IndoorScenario.preset("indoor-bridge").to_dict()["beacons"]


def test_nodes_without_anchors_and_their_velocities_are_dragged() -> None:
    scenario = KinematicsScenario.preset("kinematics-four")
    with shown(scenario) as (viewer, client):
        client.drag("/anchors/2", (10.0, 20.0, 0.0))
        expected = scenario.replace({"coefficients[0][2]": [10.0, 20.0]})
        until(lambda: viewer.shown.wish.source == expected)
        assert viewer.shown.run.to_json() == expected.run().to_json() != scenario.run().to_json()
        way = viewer.shown.arrow_seconds  # type: ignore[attr-defined]
        client.drag("/velocities/2", (10.0 + 3 * way, 20.0 - way, 0.0))
        until(lambda: np.allclose(document(viewer)["coefficients"][1][2], [3.0, -1.0]))
        client.set(client.control("ML, every distance"), True)
        until(lambda: "maximum-likelihood-full" in viewer.shown.run.estimators)


def test_localizers_are_shown_trial_by_trial() -> None:
    with shown(ROOM, "localize") as (viewer, client):
        assert viewer.shown.run[7] == ROOM.localize(7)
        client.drag("/start", (1.0, 2.0, 1.5))
        until(lambda: document(viewer)["start"]["position"] == [1.0, 2.0, 1.5])
        source = viewer.shown.wish.source
        assert isinstance(source, Scenario)
        assert viewer.shown.run[3] == source.localize(3) != ROOM.localize(3)
        client.set(client.control("LS"), False)
        until(lambda: "ls" not in document(viewer)["localize"]["enabled"])
        client.set(client.control("shown as"), "Track")
        until(lambda: viewer.shown.wish.lab == "track")
        assert (
            viewer.shown.run.to_json()
            == source.replace({"localize.enabled": document(viewer)["localize"]["enabled"]}).run().to_json()
        )


def test_presets_of_all_families_are_opened_one_after_the_other() -> None:
    with shown(ROOM) as (viewer, client):

        def shows(lab: str, preset: str) -> bool:
            return (viewer.shown.wish.lab, viewer.shown.name) == (lab, preset)

        for preset, lab in (("indoor-static", "indoor"), ("kinematics-four", "anchorless"), ("planar", "track")):
            client.set(client.control("preset"), preset)
            until(partial(shows, lab, preset))
        client.set(client.control("edits"), "undo")
        until(lambda: viewer.shown.name == "kinematics-four")


def test_trackers_over_a_recording_are_chosen() -> None:
    recording = ROOM.simulate()
    with shown(recording) as (viewer, client):
        client.set(client.control("KF"), False)
        until(lambda: "kf" not in viewer.shown.run.estimators)
        assert "uc-kf" in viewer.shown.run.estimators
    assert lab_of(recording) == "replay"
    own = ("track", "explore", "localize")
    assert {name for name in LABS if lab_of(ROOM, name if name in own else None) == name} == {*own}
