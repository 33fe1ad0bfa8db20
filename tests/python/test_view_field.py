"""The bound over a plane in the viewer: hatched above a limit, and read at a place."""

from typing import Any

import numpy as np
from rangelab import Scenario
from rangelab.view import Viewer, colours, themes
from rangelab.view.labs.probe import told_at
from viewer_client import until
from viewer_labs import shown

ROOM = Scenario.preset("room").replace(steps=10)
LIGHT = themes.THEMES["light"]


def limits(viewer: Viewer) -> tuple[Any, Any]:
    source = viewer.shown.wish.source
    assert isinstance(source, Scenario)
    field = source.to_dict()["field"]
    return field["position_limit"], field["angle_limit"]


def test_only_numbers_above_the_limit_are_hatched_and_missing_ones_are_crossed() -> None:
    values = np.array([[0.1] * 4 + [0.4] * 4] * 8)
    plain = colours.field_colours(values, LIGHT)
    assert colours.hatched(plain, values, None, LIGHT) is plain
    assert colours.hatched(plain, values, 0.5, LIGHT) is plain

    def lines(field: np.ndarray, limit: float | None) -> np.ndarray:
        found = colours.hatched(colours.field_colours(field, LIGHT), field, limit, LIGHT)
        return np.asarray(np.all(found == LIGHT.rgb("hatch"), axis=-1))

    half = 4 * colours.FINE
    above = lines(values, 0.2)
    assert not above[:, : half - colours.FINE].any()
    share = colours.LINE / colours.PERIOD
    assert np.isclose(above[:, half + colours.FINE :].mean(), share, rtol=0.1)
    missing = values.copy()
    missing[:, 4:] = np.nan
    crossed = lines(missing, None)
    assert not crossed[:, : half - colours.FINE].any()
    assert np.isclose(crossed[:, half + colours.FINE :].mean(), 2 * share - share**2, rtol=0.1)


def test_a_limit_is_typed_in_the_unit_that_is_shown() -> None:
    with shown(ROOM) as (viewer, client):

        def fields() -> int:
            return len([m for m in client.of_type("GlbMessage") if m["name"] == "/field"])

        client.set(client.control("show it"), True)
        until(lambda: fields() == 1)
        client.set(client.control("hatch worse than, m"), True)
        until(lambda: limits(viewer) == (0.01, None))
        client.set(client.control("… hatch worse than, m"), 0.008)
        until(lambda: limits(viewer) == (0.008, None))
        until(lambda: fields() >= 2)
        client.set(client.control("shows"), "bound of the orientation")
        client.set(client.control("hatch worse than, deg"), True)
        until(lambda: limits(viewer)[1] is not None)
        assert np.isclose(limits(viewer)[1], np.radians(1.0))


def test_the_bound_is_read_at_a_typed_place() -> None:
    bound = ROOM.bound_at([1.0, 2.0, 1.0])
    angle, position = np.degrees(bound["angle_sigma"]), 1e3 * bound["position_sigma"]
    told = f"Bound there: orientation {angle:.3g} deg, position {position:.3g} mm."
    assert told_at(ROOM, [1.0, 2.0, 1.0]) == told
    with shown(ROOM) as (_, client):
        start = ROOM.to_dict()["start"]["position"]
        until(lambda: told_at(ROOM, start) in str(client.messages))
        client.set(client.control("read at, m"), (1.0, 2.0, 1.0))
        until(lambda: told in str(client.of_type("GuiUpdateMessage")))
    alone = ROOM.replace(anchors=ROOM.anchors[:1])
    assert told_at(alone, [1.0, 2.0, 1.0]) == "Bound there: orientation no bound, position no bound."
