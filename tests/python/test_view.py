"""The viewer by its protocol: every edit is computed anew by the crate, and nothing breaks it."""

import re
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
import rangelab
from conftest import ROOT
from rangelab import Scenario
from rangelab.view import Viewer, colours, looks, shapes, themes
from rangelab.view.port import PortTakenError
from rangelab.view.source import opened
from viewer_client import ViewerClient

ROOM = Scenario.preset("room")


def until(true: Callable[[], object], seconds: float = 90.0) -> None:
    """Waits for something that happens in another thread."""
    end = time.monotonic() + seconds
    while not true():
        assert time.monotonic() < end, "it did not happen"
        time.sleep(0.02)


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
    assert {"/truth/path", "/truth/past", "/truth/body", "/ranges", "/estimators/uc-kf/path", "/estimators/uc-kf/body"} <= lines
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
    until(lambda: viewer.shown.field is not None)
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


@pytest.mark.parametrize("theme", themes.THEMES)
def test_colours_are_those_of_the_page(theme: str) -> None:
    css = (ROOT / "web/page/src/theme/tokens.css").read_text()
    found = re.search(rf'data-theme="{theme}"\] \{{(.*?)\n\}}', css, re.S)
    assert found is not None
    tokens = dict(re.findall(r"--([a-z-]+): (#[0-9a-f]{6})", found[1]))
    ours = themes.THEMES[theme].tokens
    assert {token: tokens.get(token) for token in ours} == ours
    weight = re.search(r"--line-weight: ([\d.]+);", found[1])
    assert themes.THEMES[theme].weight == (float(weight[1]) if weight else 1.0)
    assert themes.THEMES[theme].dark == ("color-scheme: dark" in found[1])


def test_the_field_is_coloured_as_on_the_page() -> None:
    stops = (ROOT / "web/page/src/theme/field-colours.ts").read_text()
    assert re.findall(r'^  "(#[0-9a-f]{6})"', stops, re.M) == colours.FIELD_STOPS


Written = dict[str, tuple[str, str, str, tuple[int, ...]]]


def looks_written_in(path: str) -> Written:
    """What a list of estimators of the page says: label, colour, mark and dash by name."""
    text = re.sub(r"\s+", " ", (ROOT / path).read_text())
    entries = re.findall(r'\{ name: "([^"]+)", label: "([^"]+)", (.*?)\}', text)
    found = {}
    for name, label, rest in entries:
        fields = dict(re.findall(r'(token|mark): "([^"]+)"', rest))
        dash = re.search(r"dash: (DASH|\[[\d, ]*\])", rest)
        numbers = "[7, 4]" if dash and dash[1] == "DASH" else dash[1] if dash else "[]"
        found[name] = (label, fields["token"], fields["mark"], tuple(int(n) for n in re.findall(r"\d+", numbers)))
    return found


@pytest.mark.parametrize(
    ("path", "ours", "least"),
    [
        ("web/page/src/labs/indoor/filters.ts", looks.FILTERS, 9),
        ("web/page/src/labs/anchorless/estimators.ts", looks.KINEMATICS, 7),
        ("web/page/src/labs/localize/localizers.ts", looks.LOCALIZERS, 10),
    ],
)
def test_estimators_look_as_on_the_page(path: str, ours: dict[str, looks.Look], least: int) -> None:
    written = looks_written_in(path)
    assert len(written) >= least
    assert written == {name: (ours[name].label, ours[name].token, ours[name].mark, ours[name].dash) for name in written}


def test_trackers_and_bounds_look_as_on_the_page() -> None:
    palette = (ROOT / "web/page/src/theme/palette.ts").read_text()
    marks = re.search(r"MARKS.*?\{(.*?)\}", palette, re.S)
    assert marks is not None
    found = dict(re.findall(r'"?([a-z-]+)"?: "([a-z]+)"', marks[1]))
    assert found == {name: look.mark for name, look in looks.TRACKERS.items()}
    plots = (ROOT / "web/page/src/labs/track/plots.ts").read_text()
    for name, look in looks.TRACK_BOUNDS.items():
        assert f'{name}: {{ short: "{look.label}", dash: {list(look.dash)} }}' in plots
    localizers = (ROOT / "web/page/src/labs/localize/localizers.ts").read_text()
    for name, look in looks.LOCALIZER_BOUNDS.items():
        assert f'{name}: {{ label: "{look.label}", dash: {list(look.dash)} }}' in localizers
    run = ROOM.run()
    assert {name: each.label for name, each in run.estimators.items()} == {
        name: look.label for name, look in looks.TRACKERS.items() if name in run.estimators
    }


@pytest.mark.parametrize("algorithm", [1, 2])
def test_solvers_of_both_algorithms_look_as_on_the_page(algorithm: int) -> None:
    text = (ROOT / "web/page/src/labs/anchorless/estimators.ts").read_text()
    call = re.search(rf'solvers\({algorithm}, "([a-z-]+)", \[(.*?)\]\)', text)
    assert call is not None
    marks = re.findall(r'"(\w+)"', call[2])
    solvers = re.findall(r'of\("(\w+)", "([^"]+)", "[^"]+", (\d), (DASH|LONG|DOTS|\[\])\)', text)
    dashes = {"[]": (), "DASH": (7, 4), "LONG": (14, 4), "DOTS": (2, 3)}
    assert len(solvers) == 4
    for solver, label, index, dash in solvers:
        expected = looks.Look(f"Alg. {algorithm}, {label}", call[1], marks[int(index)], dashes[dash])
        assert looks.KINEMATICS[f"algorithm-{algorithm}-{solver}"] == expected


def test_quaternions_are_rotations_and_back() -> None:
    numbers = np.random.default_rng(1)
    for _ in range(50):
        q = numbers.normal(size=4)
        rotation = shapes.rotation(q, 3)
        assert np.allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)
        assert np.allclose(shapes.rotation(shapes.quaternion(rotation), 3), rotation, atol=1e-12)
    turned = shapes.rotation(np.array([np.cos(0.3), 0, 0, np.sin(0.3)]), 2)
    assert np.allclose(turned, [[np.cos(0.6), -np.sin(0.6)], [np.sin(0.6), np.cos(0.6)]])


def test_ellipsoids_reach_as_far_as_the_covariance_says() -> None:
    covariance = np.array([[0.04, 0.01, 0.0], [0.01, 0.09, 0.0], [0.0, 0.0, 0.01]])
    vertices, _ = shapes.ellipsoid(covariance, np.zeros(3), 1.0)
    inverse = np.linalg.inv(covariance)
    assert np.allclose(np.einsum("vi,ij,vj->v", vertices, inverse, vertices), 1.0)
