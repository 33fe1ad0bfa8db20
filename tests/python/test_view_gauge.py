"""What distances cannot see, in the viewer: the page's gauge turns what is seen and leaves the motion as it is."""

import json
from unittest.mock import MagicMock

import numpy as np
import pytest
from rangelab import KinematicsScenario, from_link, to_link
from rangelab.view.labs import computed
from rangelab.view.labs.anchorless import AnchorlessPicture
from rangelab.view.labs.anchorless_handles import with_vector
from rangelab.view.labs.anchorless_levels import SENSES
from rangelab.view.labs.gauge import Gauge, evidence_of, gauge_of, seen, with_gauge
from rangelab.view.picture import Wish
from viewer_client import until
from viewer_labs import shown

FOUR = KinematicsScenario.preset("kinematics-four")
SPACE = KinematicsScenario.preset("kinematics-space")
PAGE = {"degrees": 37, "mirrored": True, "shift": [10, -250], "pivot": [51, -691]}
"""A gauge as the page writes it."""
TURNED = FOUR.replace(view={"gauge": PAGE})


def changed(scenario: KinematicsScenario, **changes: object) -> KinematicsScenario:
    found = with_gauge(**changes)(scenario)
    assert isinstance(found, KinematicsScenario)
    return found


def picture(scenario: KinematicsScenario) -> AnchorlessPicture:
    found = computed(Wish(scenario, "anchorless"))
    assert isinstance(found, AnchorlessPicture)
    return found


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("degrees", [30, 90, -90, 180, 270, -179])
def test_a_gauge_goes_there_and_back_exactly_for_quarter_turns(degrees: float, mirrored: bool) -> None:
    # A mirror and a turn undo themselves, so that only a turn alone tells back from there.
    gauge = Gauge(degrees, mirrored, [3, 4], [-5, 7])
    point, vector = np.array([11.0, 13.0]), np.array([2.0, -1.0])
    assert np.allclose(gauge.placed_back(gauge.placed(point)), point, rtol=0, atol=1e-12)
    assert np.allclose(gauge.turned_back(gauge.turned(vector)), vector, rtol=0, atol=1e-13)
    assert not np.allclose(gauge.turned(vector), vector)
    assert Gauge(90, False, [0, 0], [0, 0]).turned(np.array([2.0, 1.0])).tolist() == [-1, 2]
    mirrored_first = Gauge(90, True, [0, 0], [0, 0]).turned(np.array([2.0, 1.0]))
    assert mirrored_first.tolist() == [-1, -2]


def test_it_changes_no_distance_and_turns_all_arrows_alike() -> None:
    document = TURNED.to_dict()
    found = evidence_of(document, [-5, 0, 5])
    assert max(found.distance, found.arrow, found.turn) < 1e-9
    assert not np.allclose(seen(document)[0], document["coefficients"][0], atol=1.0)
    in_space = changed(SPACE, degrees=30.0, mirrored=True, shift=[1.0, 2.0, 3.0]).to_dict()
    assert max(vars(evidence_of(in_space, [-1, 1])).values()) < 1e-9


def test_evidence_finds_another_change_of_the_nodes_out(monkeypatch: pytest.MonkeyPatch) -> None:
    other = seen(TURNED.to_dict())
    other[1, 3] += [1, 0]
    monkeypatch.setattr("rangelab.view.labs.gauge.seen", lambda _: other)
    found = evidence_of(TURNED.to_dict(), [5])
    assert min(found.distance, found.arrow, found.turn) > 0.1


def test_a_link_of_the_page_opens_turned_and_one_of_the_viewer_has_the_hint_of_the_page() -> None:
    opened = from_link(to_link(TURNED, "https://example.org/"))
    assert isinstance(opened, KinematicsScenario)
    assert gauge_of(opened.to_dict()) == Gauge(37, True, [10, -250], [51, -691])
    turned = changed(FOUR, degrees=37, mirrored=True, shift=[10, -250])
    assert json.loads(turned.to_json())["view"] == {"gauge": PAGE}
    assert json.loads(turned.to_json())["coefficients"] == FOUR.to_dict()["coefficients"]
    assert changed(turned, degrees=0, mirrored=False, shift=[0, 0]) == FOUR
    kept = changed(FOUR.replace(view={"arrow_seconds": 4}), degrees=5)
    assert kept.to_dict()["view"]["arrow_seconds"] == 4


@pytest.mark.parametrize("hint", ["round", {"degrees": "x"}, {"degrees": 10, "shift": [1], "pivot": [0, 0]}, None])
def test_what_no_hand_should_have_written_is_no_gauge(hint: object) -> None:
    assert gauge_of(FOUR.replace(view={"gauge": hint}).to_dict()).is_identity


def test_errors_from_distances_stay_and_accelerometers_have_a_frame_of_their_own() -> None:
    one, other = picture(FOUR), picture(TURNED)
    for name, each in one.run.estimators.items():
        errors, turned = each.coefficient_errors, other.run[name].coefficient_errors
        changes = np.abs(turned / errors - 1)
        if len(changes):
            assert (changes.max() > 1e-4) if SENSES[name] else (changes.max() < 1e-5), name
    assert np.allclose(
        one.bounds["distances"].position_rmse([0.0]),  # type: ignore[union-attr]
        other.bounds["distances"].position_rmse([0.0]),  # type: ignore[union-attr]
        rtol=1e-6,
    )


def test_all_is_drawn_where_the_gauge_shows_it() -> None:
    found, canvas = picture(TURNED), MagicMock(unit=1.0)
    found.draw(canvas, 3, 20.0)
    tracks = {call.args[0]: call.args[1] for call in canvas.lines.call_args_list}
    gauge = gauge_of(TURNED.to_dict())
    places = gauge.placed(FOUR.motion.positions(found.times[3])[0])
    centres = [call.args[2] for call in canvas.ellipsoid.call_args_list][-4:]
    assert np.allclose(centres, places)
    arrows = tracks["/arrows/velocity"]
    velocities = gauge.turned(FOUR.motion.coefficients[1])
    assert np.allclose((arrows[:, 1] - arrows[:, 0])[:, :2], found.arrow_seconds * velocities)
    # Estimates are in the frame that is seen: at the true scale they lie where the nodes are.
    marks = {call.args[0]: call.args[1] for call in canvas.marks.call_args_list}
    assert np.allclose(marks["/estimators/maximum-likelihood/marks"][:, :2], places, atol=100.0)


def test_handles_write_back_through_the_gauge() -> None:
    with shown(TURNED) as (viewer, client):
        client.drag("/anchors/2", (10.0, 20.0, 0.0))
        gauge = gauge_of(TURNED.to_dict())
        until(lambda: np.allclose(viewer.shown.handles()[2].place, [10.0, 20.0]))
        document = viewer.shown.wish.source.to_dict()
        assert document["coefficients"][0][:2] == TURNED.to_dict()["coefficients"][0][:2]
        assert document["view"] == TURNED.to_dict()["view"]
        way = viewer.shown.arrow_seconds  # type: ignore[attr-defined]
        client.drag("/velocities/2", (10.0 + 3 * way, 20.0 - way, 0.0))
        wanted = gauge.turned_back(np.array([3.0, -1.0]))
        until(lambda: np.allclose(viewer.shown.wish.source.to_dict()["coefficients"][1][2], wanted, atol=1e-8))
        velocity = viewer.shown.wish.source.to_dict()["coefficients"][1][2]
        assert np.allclose(gauge.turned(np.array(velocity)), [3.0, -1.0], atol=1e-8)


def test_a_node_that_is_taken_and_not_moved_keeps_its_numbers() -> None:
    turned = changed(FOUR, degrees=37, mirrored=True, shift=[10.1, -250.3])
    places = seen(turned.to_dict())[0]
    assert any(
        gauge_of(turned.to_dict()).placed_back(place).tolist() != kept
        for place, kept in zip(places, FOUR.to_dict()["coefficients"][0], strict=True)
    )
    for n, place in enumerate(places):
        assert with_vector(0, n, place)(turned) == turned


def test_the_network_is_turned_mirrored_and_shifted_by_controls_and_back() -> None:
    with shown(FOUR) as (viewer, client):
        client.set(client.control("turn all nodes, deg"), 90.0)
        turned = changed(FOUR, degrees=90.0)
        until(lambda: viewer.shown.wish.source == turned)
        client.set(client.control("mirror all nodes in x"), True)
        until(lambda: viewer.shown.wish.source == changed(turned, mirrored=True))
        assert viewer.shown.wish.source.to_dict()["coefficients"] == FOUR.to_dict()["coefficients"]
        until(lambda: "Largest change of a distance: **" in str(client.of_type("GuiUpdateMessage")))
        client.set(client.control("edits"), "undo")
        until(lambda: viewer.shown.wish.source == turned)
        client.set(client.control("position, m"), (5.0, 6.0))
        until(lambda: np.allclose(seen(viewer.shown.wish.source.to_dict())[0][0], [5.0, 6.0]))
        client.press("Show it as it is")
        until(lambda: gauge_of(viewer.shown.wish.source.to_dict()).is_identity)


def test_the_ellipsoids_are_those_of_the_bound() -> None:
    found, canvas = picture(FOUR), MagicMock(unit=1.0)
    found.draw(canvas, 3, 20.0)
    drawn = {call.args[0]: call.args[1:] for call in canvas.ellipsoid.call_args_list}
    time = found.times[3]
    covariance = FOUR.bound("accelerometers" in found.bounds).position_covariance(time)
    places = FOUR.motion.positions(time)[0]
    dimension = places.shape[1]
    for n, place in enumerate(places):
        block = slice(n * dimension, (n + 1) * dimension)
        covariances, centre, scale, token = drawn[f"/bound/{n}"]
        assert np.array_equal(covariances, covariance[block, block])
        assert (np.array_equal(centre, place), scale, token) == (True, 20.0, "bound")
