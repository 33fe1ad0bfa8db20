"""The controls of the page's lab Explore: the bound as a landscape, where anchors should stand, what blocks ranges."""

from typing import Any

import numpy as np

from ..panel import DEGREES, Document, Panel
from ..picture import Change
from ..values import by_hand, put
from .anchors import anchor_controls
from .choices import Chosen
from .obstacles import obstacle_controls
from .placement import placement_controls

SHOWN = (
    ("position", "bound of the position"),
    ("orientation", "bound of the orientation"),
    ("next_anchor", "best next anchor"),
)
PLANES = (
    ("level", "level, through the body"),
    ("horizontal", "level, at a height"),
    ("vertical", "upright"),
    ("body", "the body's own x and y"),
)


def explore_controls(panel: Panel) -> None:
    """All that the bound depends on, besides the ranges' noise."""
    with panel.folder("Bound over a plane", opened=True):
        _field(panel)
    with panel.folder("Placement", opened=True):
        placement_controls(panel)
    with panel.folder("Walls and boxes", opened=True):
        obstacle_controls(panel)
    with panel.folder("Anchors"):
        anchor_controls(panel)
    with panel.folder("Sensors on the body"):
        _sensors(panel)


def _field(panel: Panel) -> None:
    shown = panel.gui.add_checkbox("show it", panel.studio.wish.field)
    by_hand(shown, lambda value: panel.studio.ask(field=value))
    panel.on_follow(lambda _: put(shown, panel.studio.wish.field))
    panel.chooser("shows", SHOWN, _shown, lambda value: panel.edit("shown", _showing(value)))
    panel.chooser(
        "plane",
        PLANES,
        lambda document: str(document["field"]["plane"]["kind"]),
        lambda kind: panel.edit("plane", _on_plane(kind)),
    )
    panel.number("field.plane.height", "height, m", step=0.1)
    panel.number("field.plane.heading", "heading, deg", factor=DEGREES, step=5.0)
    panel.number("field.plane.offset", "off the origin, m", step=0.1)
    panel.choice("field.form", "ranges", (("raw", "raw"), ("projected", "projected")))
    panel.number("field.headings", "headings averaged over", step=1, least=1)


def _shown(document: Document) -> str:
    of = document["field"]
    return str("next_anchor" if of["subject"] == "next_anchor" else of["quantity"])


def _showing(value: str) -> Change:
    """The field of another thing."""
    if value == "next_anchor":
        return lambda scenario: scenario.replace({"field.subject": value})
    return lambda scenario: scenario.replace({"field.subject": "body", "field.quantity": value})


def _on_plane(kind: str) -> Change:
    """The field on another plane, which begins in the middle of the anchors or at the body."""

    def change(scenario: Any) -> Any:
        document = scenario.to_dict()
        anchors = np.array(document["anchors"])
        plane: Document = {"kind": kind}
        if kind == "horizontal":
            plane["height"] = float(f"{(anchors.min(axis=0) + anchors.max(axis=0))[-1] / 2:.3g}")
        elif kind == "vertical":
            plane |= {"heading": 0.0, "offset": float(f"{document['start']['position'][1]:.3g}")}
        return scenario.replace({"field.plane": plane})

    return change


def _sensors(panel: Panel) -> None:
    """Where each sits, in the frame of the body."""
    chosen = Chosen(panel, "sensor", lambda document: [f"S{n + 1}" for n in range(len(document["sensors"]))])
    chosen.vector("sensors[#]", "position, m", step=0.05)
    chosen.act("Remove the sensor", _without_sensor)
    panel.button("Add a sensor", lambda: panel.edit("sensor", _with_sensor))
    panel.number("mounting_sigma", "mounting error σ_e, m", step=0.01, least=0.0)


def _with_sensor(scenario: Any) -> Any:
    sensors = np.array(scenario.to_dict()["sensors"])
    # Twice as far out as the first: never where another one sits.
    return scenario.replace(sensors=[*sensors.tolist(), (2 * sensors[0] + 0.1).tolist()])


def _without_sensor(index: int) -> Change:
    def change(scenario: Any) -> Any:
        sensors = scenario.to_dict()["sensors"]
        return scenario.replace(sensors=[each for n, each in enumerate(sensors) if n != index])

    return change
