"""The viewer by its protocol: every edit is computed anew by the crate, and nothing breaks it."""

import re
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import rangelab
from rangelab import Scenario
from rangelab.view import Viewer, shapes
from rangelab.view.labs.track import TrackPicture
from rangelab.view.port import PortTakenError
from rangelab.view.source import opened
from viewer_client import ViewerClient, until

ROOM = Scenario.preset("room")


@pytest.fixture
def viewer() -> Iterator[Viewer]:
    found = Viewer(ROOM, port=0)
    yield found
    found.stop()


@pytest.fixture
def client(viewer: Viewer) -> Iterator[ViewerClient]:
    found = ViewerClient(viewer.port)
    until(lambda: found.of_type("TransformControlsMessage") and found.of_type("GuiUplotMessage"))
    yield found
    found.close()


def test_the_scene_and_the_panel_are_sent(client: ViewerClient) -> None:
    gizmos = {message["name"] for message in client.of_type("TransformControlsMessage")}
    assert gizmos == {"/start", *(f"/anchors/{m}" for m in range(6))}
    lines = {message["name"] for message in client.of_type("LineSegmentsMessage")}
    assert {
        "/truth/path",
        "/truth/past",
        "/truth/body",
        "/ranges",
        "/estimators/uc-kf/path",
        "/estimators/uc-kf/body",
    } <= lines
    assert {"/estimators/uc-kf/ellipsoid"} <= {message["name"] for message in client.of_type("MeshMessage")}
    assert len(client.of_type("GuiUplotMessage")) == 5


def test_dragging_an_anchor_moves_the_estimates_to_those_of_the_crate(viewer: Viewer, client: ViewerClient) -> None:
    before = viewer.shown.run["uc-kf"].positions
    client.drag("/anchors/1", (2.0, 1.0, 3.0))
    until(lambda: tuple(viewer.shown.run.anchors[1]) == (2.0, 1.0, 3.0))
    expected = ROOM.replace({"anchors[1]": [2.0, 1.0, 3.0]}).run()
    assert viewer.shown.run.to_json() == expected.to_json()
    assert not np.array_equal(viewer.shown.run["uc-kf"].positions, before)


def test_dragging_the_body_moves_its_start(viewer: Viewer, client: ViewerClient) -> None:
    client.drag("/start", (1.0, 2.0, 1.5))
    until(lambda: viewer.shown.wish.source.to_dict()["start"]["position"] == [1.0, 2.0, 1.5])
    assert viewer.shown.wish.source.to_dict()["start"]["orientation"] == np.eye(3).tolist()


def test_controls_write_the_scenario(viewer: Viewer, client: ViewerClient) -> None:
    client.set(client.control("seed"), 7)
    until(lambda: viewer.shown.wish.source.to_dict()["seed"] == 7)
    client.set(client.control("KF"), False)
    until(lambda: "kf" not in viewer.shown.run.estimators)
    client.set(client.control("show it"), True)
    until(lambda: isinstance(viewer.shown, TrackPicture) and viewer.shown.field is not None)
    until(lambda: "/field" in {message["name"] for message in client.of_type("GlbMessage")})
    client.set(client.control("preset"), "planar")
    until(lambda: viewer.shown.run.dimension == 2)


def test_a_refused_edit_says_why_and_keeps_the_scene(viewer: Viewer, client: ViewerClient) -> None:
    before = viewer.shown.run.to_json()
    client.set(client.control("interval, s"), -3.0)
    until(lambda: any("Not possible" in str(message) for message in client.of_type("GuiUpdateMessage")))
    assert viewer.shown.run.to_json() == before
    client.set(client.control("seed"), 3)
    until(lambda: viewer.shown.run.to_json() == ROOM.replace(seed=3).run().to_json())


def test_a_link_of_the_page_is_opened_and_given(viewer: Viewer, client: ViewerClient) -> None:
    scenario = Scenario.preset("planar").replace(seed=12)
    client.set(client.control("link"), rangelab.to_link(scenario, "https://example.org/"))
    until(lambda: viewer.shown.wish.source == scenario)
    until(lambda: rangelab.to_link(scenario) in str(client.of_type("GuiUpdateMessage")))


def test_an_occupied_port_is_an_error_with_advice() -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        with pytest.raises(PortTakenError, match=f"port {port} .* --port {port + 1}"):
            Viewer(ROOM, port=port)
        command = [sys.executable, "-m", "rangelab.view", "room", "--port", str(port)]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == 1
        assert re.match(r"error: port \d+ of 127\.0\.0\.1 cannot be used", done.stderr)


def test_the_command_prints_the_port_that_is_used_and_ends() -> None:
    command = [sys.executable, "-m", "rangelab.view", "planar", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        said = next(line for line in process.stdout if line.startswith("rangelab: "))
        port = int(said.split("localhost:")[1].split()[0])
        with socket.create_connection(("127.0.0.1", port), timeout=5):
            pass
        process.terminate()


@pytest.mark.parametrize("ending", [".html", ".viser"])
def test_a_run_is_saved_as_a_player(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"room{ending}"
    command = [sys.executable, "-m", "rangelab.view", "room", "--port", "0", "--save", str(path)]
    subprocess.run(command, check=True)
    assert path.stat().st_size > 20_000
    assert ending != ".html" or path.read_text().lstrip().lower().startswith("<!doctype html")


def test_recordings_and_files_are_opened(tmp_path: Path) -> None:
    recording, scenario = tmp_path / "recording.json", tmp_path / "scenario.json"
    recording.write_text(ROOM.simulate().to_json())
    scenario.write_text(ROOM.to_json())
    assert opened(str(scenario)) == ROOM
    assert opened(rangelab.to_link(ROOM)) == ROOM
    found = Viewer(opened(str(recording)), port=0)
    try:
        assert found.shown.run.to_json() == ROOM.simulate().run().to_json()
    finally:
        found.stop()
    with pytest.raises(rangelab.Error, match="no preset"):
        opened("nowhere")


def test_quaternions_are_rotations_and_back() -> None:
    numbers = np.random.default_rng(1)
    for _ in range(50):
        q = numbers.normal(size=4)
        rotation = shapes.rotation(q, 3)
        assert np.allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)
        assert np.allclose(shapes.rotation(shapes.quaternion(rotation), 3), rotation, atol=1e-12)
    turned = shapes.rotation(np.array([np.cos(0.3), 0, 0, np.sin(0.3)]), 2)
    assert np.allclose(turned, [[np.cos(0.6), -np.sin(0.6)], [np.sin(0.6), np.cos(0.6)]])


def test_ellipsoids_hold_95_percent() -> None:
    # Quantiles of chi-square as tables print them.
    for dimension, quantile in ((1, 3.841), (2, 5.991), (3, 7.815)):
        assert shapes.radius_95(dimension) ** 2 == pytest.approx(quantile, abs=5e-4)
    covariance = np.array([[0.04, 0.01, 0.0], [0.01, 0.09, 0.0], [0.0, 0.0, 0.01]])
    for d, quantile in ((2, 5.991), (3, 7.815)):
        vertices, _ = shapes.ellipsoid(covariance[:d, :d], np.zeros(d), 10.0)
        outer = vertices[np.abs(vertices[:, 2]) < 1e-9, :2] if d == 2 else vertices
        distances = np.einsum("vi,ij,vj->v", outer, np.linalg.inv(covariance[:d, :d]), outer)
        assert distances.max() == pytest.approx(100 * quantile, rel=1e-4)
        assert d == 2 or np.allclose(distances, 100 * quantile, rtol=1e-4)
    with_ellipsoids = Viewer(ROOM, port=0)
    try:
        assert "Ellipsoids hold 95 %" in with_ellipsoids.said
    finally:
        with_ellipsoids.stop()
