"""The lab Explore of the viewer: what ranges hide, the body on its bench, round values of the field."""

from typing import Any

import numpy as np
import pytest
from rangelab import Scenario, topologies
from rangelab.view import contours, shapes, stage
from rangelab.view.labs import computed
from rangelab.view.labs.bench import Bench
from rangelab.view.labs.body_designer import before_the_body_changed, compared, topology_of
from rangelab.view.labs.explore import ExplorePicture
from rangelab.view.labs.ghost import motion_of, turn
from rangelab.view.labs.size_curve import SizeCurves, size_for, size_of
from rangelab.view.picture import Wish
from viewer_client import ViewerClient, until
from viewer_labs import shown

ROOM = Scenario.preset("room").replace(steps=5)
ROD = ROOM.replace(sensors=[[-0.35, 0, 0], [0.1, 0, 0], [0.35, 0, 0]])


def picture(scenario: Scenario) -> ExplorePicture:
    found = computed(Wish(scenario, "explore", field=True))
    assert isinstance(found, ExplorePicture)
    return found


def sent(client: ViewerClient, kind: str) -> set[str]:
    return {message["name"] for message in client.of_type(kind)}


def test_the_bounds_and_singular_values_of_the_crate_are_told() -> None:
    table, found = picture(ROOM).readout(0), ROOM.explore()
    rows = {row.look.label: (row.first, row.numbers) for row in table.rows}
    assert rows["body"] == (0, (float(np.degrees(found["angle_sigma"])), found["position_sigma"]))
    assert rows["centred anchors, m"] == (2, tuple(found["anchor_singular_values"]))
    assert rows["[C; 1] of the sensors"] == (2, tuple(found["sensor_singular_values"]))


def test_a_motion_that_no_range_sees_leaves_all_ranges_as_they_are() -> None:
    found = picture(ROD)
    motion, start = found.motion, found.document["start"]
    assert motion is not None
    assert motion.times is None
    turned, place = np.array(start["orientation"]), np.array(start["position"])
    assert np.linalg.norm(motion.rotation) > 0.1
    moved = motion.moved(turned, place, ROD.sensors, 1.0)
    still = shapes.body(turned, place, ROD.sensors)
    ranges, before = (np.linalg.norm(ROD.anchors[:, None] - each[None], axis=2) for each in (moved, still))
    assert np.allclose(ranges, before, atol=1e-9)
    assert "Ghost (blue): the motion that no range sees." in found.sentences()
    assert all(np.isnan(number) for number in found.readout(0).rows[0].numbers)


def test_a_small_motion_is_drawn_by_a_round_number_of_standard_deviations() -> None:
    mode = {"rotation": [0.0, 0.0, 1.0], "shift": [0.0, 0.0, 0.0], "standard_deviation": 0.001}
    motion = motion_of(mode, 0.2, 5.0)
    assert motion.times == 100
    assert np.allclose(motion.rotation, [0, 0, 0.1])
    assert motion.sentence.endswith("by 100 σ.")
    assert motion_of({**mode, "standard_deviation": 2.0}, 0.2, 5.0).rotation[2] == pytest.approx(np.pi / 3)
    assert np.allclose(turn(np.array([0.0, 0.0, np.pi / 2])) @ [1, 0, 0], [0, 1, 0])


def test_a_twin_with_the_same_ranges_is_drawn_and_told() -> None:
    flat = ROOM.replace(anchors=[[0, 0, 0], [6, 0, 0], [6, 5, 0], [0, 5, 0]])
    found = picture(flat)
    assert found.run["twin"] is not None, "this scene has no twin any more"
    assert any("drawn dashed" in sentence for sentence in found.sentences())
    with shown(flat, "explore") as (_, client):
        until(lambda: {"/twin/body", "/ghost/there"} <= sent(client, "LineSegmentsMessage"))


def test_sensors_are_dragged_on_the_bench_and_the_change_is_told() -> None:
    with shown(ROOM, "explore") as (viewer, client):
        bench = Bench.of(ROOM.anchors, ROOM.sensors)
        wanted = np.array([0.2, 0.1, 0.05])
        to = bench.places(wanted[None])[0]
        client.drag("/bench/sensor/1", (float(to[0]), float(to[1]), float(to[2])))
        until(lambda: not np.array_equal(viewer.shown.wish.source.sensors, ROOM.sensors))  # type: ignore[union-attr]
        now = viewer.shown.wish.source
        assert isinstance(now, Scenario)
        assert np.allclose(now.sensors[1], wanted, atol=1e-9)
        assert np.array_equal(now.sensors[[0, 2]], ROOM.sensors[[0, 2]])
        told = compared(now.explore()["angle_sigma"], ROOM.explore()["angle_sigma"])
        assert told.endswith(("better", "worse"))
        until(lambda: told in str(client.of_type("GuiUpdateMessage")))
        client.set(client.control("body"), "cube")
        cube = next(body["sensors"] for body in topologies(3) if body["name"] == "cube")
        until(lambda: topology_of(viewer.shown.wish.source.sensors) == "cube")  # type: ignore[union-attr]
        body = viewer.shown.wish.source
        assert isinstance(body, Scenario)
        assert np.allclose(body.sensors, size_of(now.sensors) * np.array(cube), rtol=1e-8)
        client.set(client.control("size, m"), 0.8)
        until(lambda: np.isclose(size_of(viewer.shown.wish.source.sensors), 0.8))  # type: ignore[union-attr]


def test_changes_are_told_as_on_the_page() -> None:
    numbers: list[tuple[float | None, float | None]] = [(0.9, 1.0), (1.05, 1.0), (3.2, 1.0), (None, 1.0), (1.0, None)]
    told = ["10 % better", "5.0 % worse", "3.20 × worse", "lost", "new"]
    assert [compared(*pair) for pair in numbers] == told
    assert compared(1.0001, 1.0) == "the same"
    assert before_the_body_changed(ROD, Wish(ROOM, "explore")) is ROOM
    assert before_the_body_changed(ROD.replace(seed=9), Wish(ROOM, "explore")) is None
    assert before_the_body_changed(ROOM, None) is None


def test_the_size_curve_is_that_of_the_crate() -> None:
    curves = SizeCurves.of(ROOM)
    own = int(np.argmin(np.abs(curves.sizes - curves.size)))
    assert curves.sizes[own] == curves.size == size_of(ROOM.sensors)
    assert curves.bounds["raw"][own] == pytest.approx(np.degrees(ROOM.explore()["angle_sigma"]), rel=1e-9)
    assert "(∝ 1/size)" in curves.sentence()
    needed = size_for(1.0, curves.sizes, curves.bounds["raw"])
    assert needed is not None
    assert np.degrees(ROOM.size_curve([needed / curves.size]))[0] == pytest.approx(1.0, rel=1e-2)
    assert SizeCurves.of(ROD).sentence() == "No size lets these sensors see every rotation."
    assert curves.plot().logarithmic_x


def test_round_values_lie_where_the_field_has_them() -> None:
    assert contours.round_levels(0.9, 12) == [1, 2, 5, 10]
    assert contours.round_levels(5.7, 12.3) == [7, 10] or len(contours.round_levels(5.7, 12.3)) >= 4
    across = np.linspace(1.0, 8.0, 200)
    logs = np.log(np.tile(across, (50, 1)))
    levels = contours.Levels((2.0, 5.0), "m", 1.0)
    crossed = contours.crossings(logs, levels)
    for number, value in enumerate(levels.values, 1):
        columns = np.unique(np.nonzero(crossed == number)[1])
        assert len(columns) == 1
        assert across[columns[0]] <= value <= across[columns[0] + 1]
    places = contours.label_places(crossed, levels)
    assert [text for text, _, _ in places] == ["2 m", "5 m"]
    logs[:, 100:] = np.nan
    assert not (contours.crossings(logs, levels)[:, 98:] > 0).any()


def test_a_press_on_the_field_reads_it() -> None:
    field = ROOM.field(8)
    middle = field.points[2, 3]
    hit = shapes.hit(field, middle + np.array([0.0, 1.0, 3.0]), np.array([0.0, -1.0, -3.0]))
    assert hit is not None
    assert np.allclose(hit, middle)
    assert shapes.hit(field, middle + np.array([0.0, 1.0, 3.0]), np.array([0.0, 1.0, 3.0])) is None
    with shown(ROOM, "explore") as (viewer, client):
        client.set(client.control("read at, m"), tuple(middle.tolist()))
        until(lambda: "/probe/position" in sent(client, "MeshMessage"))
        rows: dict[str, Any] = {row.look.label: row.numbers for row in viewer.shown.readout(0).rows}
        assert rows["read at"][1] == ROOM.bound_at(middle)["position_sigma"]


@pytest.mark.parametrize(("name", "edges"), [("cube", 12), ("pyramid", 8), ("cross", 12), ("square", 4), ("rod", 1)])
def test_a_body_is_drawn_by_the_edges_of_its_hull(name: str, edges: int) -> None:
    body = np.array(next(body["sensors"] for body in topologies(3) if body["name"] == name))
    assert len(shapes.frame(body, body)) == edges


@pytest.mark.parametrize("aspect", [0.5, 1.0, 2.0])
def test_the_camera_sees_the_whole_scene_and_no_more(aspect: float) -> None:
    fov, outline = 1.2, picture(ROOM).outline
    target, place = stage.seen_whole(outline, fov, aspect)
    forward = (target - place) / np.linalg.norm(target - place)
    right = np.cross(forward, [0, 0, 1.0])
    right /= np.linalg.norm(right)
    away = outline - place
    depth = away @ forward
    across = np.abs(away @ right) / (depth * np.tan(fov / 2) * aspect)
    upright = np.abs(away @ np.cross(right, forward)) / (depth * np.tan(fov / 2))
    assert max(across.max(), upright.max()) == pytest.approx(stage.FILL)
