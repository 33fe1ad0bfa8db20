"""What stands in a room beside anchors and body: what is in the way, where anchors may and should stand, the bound."""

from typing import Any

import numpy as np

from ...arrays import Floats
from ...field import Field
from ...scenario import Scenario
from ..canvas import Canvas
from ..picture import Wish
from .field_told import draw_field
from .obstacles import draw_obstacles
from .placement_boxes import downhill, draw_arrows, draw_boxes

FIELD_CELLS = 48
"""Along the longer edge of a field."""


def field_of(wish: Wish, scenario: Scenario) -> Field | None:
    """The bound over a plane, where it is wished for."""
    return scenario.field(FIELD_CELLS) if wish.field else None


def advice_of(wish: Wish, scenario: Scenario) -> dict[str, Any] | None:
    """In which way anchors get better, where it is wished for; those that are drawn anew have no places."""
    drawn_anew = scenario.to_dict()["redraw_anchors"] is not None
    return scenario.advise() if wish.advice and not drawn_anew else None


def draw_room(
    canvas: Canvas, document: dict[str, Any], outline: Floats, field: Field | None, advice: dict[str, Any] | None
) -> None:
    """All of it, in a scene of this outline."""
    draw_obstacles(canvas, document, outline)
    draw_boxes(canvas, document)
    if advice is not None:
        ways = downhill(np.array(advice["gradient"]), document["placement"]["fixed"])
        draw_arrows(canvas, np.array(document["anchors"]), ways)
    if field is not None:
        draw_field(canvas, field, document)
