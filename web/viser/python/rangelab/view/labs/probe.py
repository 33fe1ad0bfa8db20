"""The bound at a place that is typed, or pressed in the scene."""

from collections.abc import Iterable
from typing import Any

from ...scenario import Scenario
from ..panel import Document, Panel
from ..picture import Wish
from ..state import Studio
from ..values import by_hand, put
from .placement import value_of


class Probe:
    """A place, at first that of the body, and the bound there."""

    def __init__(self, panel: Panel) -> None:
        self._panel = panel
        self._boxes: dict[int, Any] = {
            2: panel.gui.add_vector2("read at, m", (0.0, 0.0), step=0.1, visible=False),
            3: panel.gui.add_vector3("read at, m", (0.0, 0.0, 0.0), step=0.1, visible=False),
        }
        self._told = panel.gui.add_markdown("")
        for box in self._boxes.values():
            by_hand(box, lambda place: read_at(panel.studio, place))
        panel.on_follow(self._follow)

    def _follow(self, document: Document) -> None:
        wish, dimension = self._panel.studio.wish, document["dimension"]
        place = probed(wish) or document["start"]["position"]
        for count, box in self._boxes.items():
            box.visible = count == dimension
        put(self._boxes[dimension], tuple(place))
        if isinstance(wish.source, Scenario):
            self._told.content = told_at(wish.source, list(place))


def read_at(studio: Studio, place: Iterable[float]) -> None:
    """Reads the bound at a place (D, m, or 3 as it was pressed), which is no edit."""
    wish = studio.wish
    if isinstance(wish.source, Scenario):
        studio.add(wish, probe=tuple(float(value) for value in place)[: wish.source.dimension])


def probed(wish: Wish) -> tuple[float, ...] | None:
    """The place that was typed or pressed, where it is one of this document."""
    fits = wish.probe is not None and isinstance(wish.source, Scenario) and len(wish.probe) == wish.source.dimension
    return wish.probe if fits else None


def told_at(scenario: Scenario, place: list[float]) -> str:
    """The bounds of a body at a place (m), in a sentence."""
    found = scenario.bound_at(place)
    angle, position = value_of(found["angle_sigma"], "rad"), value_of(found["position_sigma"], "m")
    return f"Bound there: orientation {angle}, position {position}."
