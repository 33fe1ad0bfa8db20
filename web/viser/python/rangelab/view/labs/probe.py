"""The bound at a place that is typed."""

from typing import Any

from ...scenario import Scenario
from ..panel import Document, Panel
from ..values import by_hand, put
from .placement import value_of


class Probe:
    """A place, at first that of the body, and the bound there."""

    def __init__(self, panel: Panel) -> None:
        self._panel = panel
        self._typed: list[float] | None = None
        self._boxes: dict[int, Any] = {
            2: panel.gui.add_vector2("read at, m", (0.0, 0.0), step=0.1, visible=False),
            3: panel.gui.add_vector3("read at, m", (0.0, 0.0, 0.0), step=0.1, visible=False),
        }
        self._told = panel.gui.add_markdown("")
        for box in self._boxes.values():
            by_hand(box, self._type)
        panel.on_follow(self._follow)

    def _type(self, place: tuple[float, ...]) -> None:
        self._typed = list(place)
        document = self._panel.studio.document
        if document is not None:
            self._follow(document.to_dict())

    def _follow(self, document: Document) -> None:
        scenario, dimension = self._panel.studio.document, document["dimension"]
        place = self._typed if self._typed and len(self._typed) == dimension else document["start"]["position"]
        for count, box in self._boxes.items():
            box.visible = count == dimension
        put(self._boxes[dimension], tuple(place))
        if isinstance(scenario, Scenario):
            self._told.content = told_at(scenario, place)


def told_at(scenario: Scenario, place: list[float]) -> str:
    """The bounds of a body at a place (m), in a sentence."""
    found = scenario.bound_at(place)
    angle, position = value_of(found["angle_sigma"], "rad"), value_of(found["position_sigma"], "m")
    return f"Bound there: orientation {angle}, position {position}."
