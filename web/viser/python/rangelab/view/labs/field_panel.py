"""The controls of the bound over a plane."""

from typing import Any

import numpy as np

from ..panel import DEGREES, Document, Panel
from ..picture import Change
from ..values import by_hand, put
from .choices import HIDDEN
from .probe import Probe

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


def field_controls(panel: Panel) -> None:
    """What is shown over which plane, where it is hatched, and what it is at a place."""
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
    _limit(panel, "position_limit", "hatch worse than, m", 1.0, angles=False)
    _limit(panel, "angle_limit", "hatch worse than, deg", DEGREES, angles=True)
    Probe(panel)


def in_angles(document: Document) -> bool:
    """Whether what is shown is in radians; else it is in metres."""
    of = document["field"]
    return bool((of["quantity"] if of["subject"] == "body" else document["placement"]["target"]) == "orientation")


def _limit(panel: Panel, key: str, label: str, factor: float, *, angles: bool) -> None:
    """Numbers above it are hatched; there is one for angles and one for lengths."""

    def read(document: Document) -> float | str | None:
        value = document["field"][key]
        if in_angles(document) != angles:
            return HIDDEN
        return None if value is None else factor * float(value)

    first = 1.0 if angles else 0.01
    panel.optional(
        label, read, lambda value: panel.put(f"field.{key}", None if value is None else value / factor), first=first
    )


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
