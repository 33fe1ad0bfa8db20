"""What distances cannot see: the whole network turned, mirrored and shifted, with its velocities and accelerations."""

from typing import Any

import numpy as np

from ...arrays import Floats
from ..panel import Document, Panel
from ..picture import Change


def gauge_controls(panel: Panel) -> None:
    """Buttons that move all nodes as one; what estimators find of the motion stays as good as it is."""
    angle = panel.gui.add_number("turn by, deg", 30.0, step=5.0)
    panel.button("Turn all nodes", lambda: panel.edit("turn", turned(float(angle.value))), hint="about their middle")
    panel.button("Mirror all nodes", lambda: panel.edit("mirror", mirrored), hint="in x, at their middle")
    boxes: dict[int, Any] = {
        2: panel.gui.add_vector2("shift by, m", (10.0, 0.0), step=1.0, visible=False),
        3: panel.gui.add_vector3("shift by, m", (10.0, 0.0, 0.0), step=1.0, visible=False),
    }

    def follow(document: Document) -> None:
        for count, box in boxes.items():
            box.visible = count == len(document["coefficients"][0][0])

    def shift() -> None:
        way = next(box.value for box in boxes.values() if box.visible)
        panel.edit("shift", shifted(np.array(way)))

    panel.on_follow(follow)
    panel.button("Shift all nodes", shift)


def turned(degrees: float) -> Change:
    """All nodes turned about their middle, counter-clockwise; in space about the vertical."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return lambda scenario: _moved(scenario, np.array([[c, -s], [s, c]]))


def mirrored(scenario: Any) -> Any:
    """All nodes mirrored in x at their middle."""
    return _moved(scenario, np.diag([-1.0, 1.0]))


def shifted(way: Floats) -> Change:
    """All nodes shifted by a way (D, m)."""

    def change(scenario: Any) -> Any:
        coefficients = np.array(scenario.to_dict()["coefficients"])
        coefficients[0] += way
        return scenario.replace(coefficients=coefficients)

    return change


def _moved(scenario: Any, in_plane: Floats) -> Any:
    """Places about their middle and all derivatives, their x and y changed by a matrix (2 x 2)."""
    coefficients = np.array(scenario.to_dict()["coefficients"])
    middle = np.zeros_like(coefficients)
    middle[0] = coefficients[0].mean(axis=0)
    centred = coefficients - middle
    centred[..., :2] = centred[..., :2] @ in_plane.T
    return scenario.replace(coefficients=centred + middle)
