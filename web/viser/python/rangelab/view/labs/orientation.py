"""Orientations as people type them: degrees about the axes, `R = R_z(yaw) R_y(pitch) R_x(roll)`; one in the plane."""

from typing import Any

import numpy as np

from ...arrays import Floats
from ..panel import DEGREES, Document, Panel
from ..values import by_hand, put

UPRIGHT = 1e-9
"""Above this cosine of the pitch roll and yaw can be told apart."""
DIGITS = 9


def angles_of(rotation: Floats) -> list[float]:
    """The angles of a rotation, deg; of another matrix those of the columns that they are read from."""
    if len(rotation) == 2:
        return [DEGREES * float(np.arctan2(rotation[1, 0], rotation[0, 0]))]
    cosine = np.hypot(rotation[0, 0], rotation[1, 0])
    pitch = np.arctan2(-rotation[2, 0], cosine)
    if cosine < UPRIGHT:
        roll, yaw = 0.0, np.arctan2(-rotation[0, 1], rotation[1, 1])
    else:
        roll, yaw = np.arctan2(rotation[2, 1], rotation[2, 2]), np.arctan2(rotation[1, 0], rotation[0, 0])
    return [DEGREES * float(angle) for angle in (roll, pitch, yaw)]


def rotation_of(angles: list[float]) -> Floats:
    """The rotation of one angle or of three, deg."""
    cosines, sines = np.cos(np.radians(angles)), np.sin(np.radians(angles))
    if len(angles) == 1:
        return np.array([[cosines[0], -sines[0]], [sines[0], cosines[0]]])
    (ca, cb, cc), (sa, sb, sc) = cosines, sines
    about_x = np.array([[1, 0, 0], [0, ca, -sa], [0, sa, ca]])
    about_y = np.array([[cb, 0, sb], [0, 1, 0], [-sb, 0, cb]])
    about_z = np.array([[cc, -sc, 0], [sc, cc, 0], [0, 0, 1]])
    return np.asarray(about_z @ about_y @ about_x)


def orientation_control(panel: Panel, path: str, label: str) -> None:
    """Roll, pitch and yaw of a rotation of the document; its heading in the plane."""
    heading = panel.gui.add_number(f"{label}, deg", 0.0, min=-360.0, max=360.0, step=1.0)
    heading.precision = DIGITS
    triple = panel.gui.add_vector3(
        f"{label}, deg",
        (0.0, 0.0, 0.0),
        min=(-360.0, -90.0, -360.0),
        max=(360.0, 90.0, 360.0),
        step=1.0,
        hint="roll, pitch, yaw",
    )
    boxes: dict[int, Any] = {1: heading, 3: triple}

    def follow(document: Document) -> None:
        shown = tuple(round(angle, DIGITS) + 0.0 for angle in angles_of(np.array(panel.value(document, path))))
        for count, box in boxes.items():
            box.visible = len(shown) == count
        put(boxes[len(shown)], shown[0] if len(shown) == 1 else shown)

    for box in boxes.values():
        by_hand(box, lambda value: panel.put(path, rotation_of(np.atleast_1d(value).tolist())))
    panel.on_follow(follow)


def start_controls(panel: Panel) -> None:
    """Where the body begins."""
    panel.vector("start.position", "position, m", step=0.1)
    orientation_control(panel, "start.orientation", "orientation")
