"""The bound over a plane: in a sentence, hatched above its limit, with lines of round values."""

from typing import Any

import numpy as np

from ...field import Field
from ..canvas import Canvas
from ..contours import Levels
from .field_panel import in_angles


def limit_of(document: dict[str, Any]) -> float | None:
    """What is worse is hatched, m or rad."""
    limit: float | None = document["field"]["angle_limit" if in_angles(document) else "position_limit"]
    return limit


def levels_of(field: Field, document: dict[str, Any]) -> Levels:
    """Round values in the unit that is shown."""
    angles = in_angles(document)
    return Levels.of(field.values, "deg" if angles else "mm", float(np.degrees(1.0)) if angles else 1e3)


def field_sentence(field: Field, document: dict[str, Any]) -> str:
    """What the colours mean; empty where there is no bound at all."""
    if not np.isfinite(field.values).any():
        return ""
    levels = levels_of(field, document)
    of = "orientation" if levels.unit == "deg" else "position"
    low, high = (levels.factor * edge(field.values) for edge in (np.nanmin, np.nanmax))
    where = "" if document["field"]["subject"] == "body" else ", one more anchor there"
    told = f"Bound of the {of}{where}: {low:.3g} {levels.unit} (dark) to {high:.3g} {levels.unit} (bright)."
    limit = limit_of(document)
    return told if limit is None else f"{told} Hatched: worse than {levels.factor * limit:.3g} {levels.unit}."


def draw_field(canvas: Canvas, field: Field, document: dict[str, Any]) -> None:
    """The colours, the lines and their values."""
    canvas.field("/field", field, limit_of(document), levels_of(field, document))
