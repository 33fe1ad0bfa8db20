"""How a scenario of the Anchorless lab is drawn, kept among its hints for the page: it travels with a link."""

from typing import Any

import numpy as np

from ..panel import Document
from ..picture import Change

ARROWS, ERRORS = "arrow_seconds", "error_scale"
LIMITS = {ARROWS: (1e-3, 1e7), ERRORS: (1.0, 1e9)}
"""The least and the most that a hint may be; s, and times."""


def hint_of(document: Document, key: str) -> float | None:
    """A number of the view; a hint may be anything, for a link can be written by hand."""
    value, (least, most) = (document["view"] or {}).get(key), LIMITS[key]
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return float(value) if least <= value <= most else None


def with_hint(key: str, value: float) -> Change:
    """The edit of such a number."""

    def change(scenario: Any) -> Any:
        return scenario.replace(view={**(scenario.to_dict()["view"] or {}), key: value})

    return change


def interval_of(document: Document) -> tuple[float, float]:
    """The first and the last stamp, s."""
    stamps = document["stamps"]
    if stamps["kind"] == "regular":
        return float(stamps["first"]), float(stamps["last"])
    return float(np.min(stamps["times"])), float(np.max(stamps["times"]))


def arrow_seconds(document: Document) -> float:
    """Arrows reach where the velocity alone, or the acceleration alone, would carry a node in this time, s."""
    first, last = interval_of(document)
    return hint_of(document, ARROWS) or (2 * (last - first) if last > first else 1.0)


def reach(document: Document, order: int) -> float:
    """From a node to the tip of its arrow for each unit of the derivative: the way in that time, t or t²/2."""
    seconds = arrow_seconds(document)
    return seconds if order == 1 else seconds**2 / 2
