"""The points of a path that is drawn by hand, by their numbers."""

from typing import Any

import numpy as np

from ..panel import Document, Panel
from ..picture import Change
from ..values import by_hand, put
from .choices import Chosen

PATH = "motion.path.points"


def way_point_controls(panel: Panel) -> None:
    """How high the path lies, whether it is closed, and where each point is; nothing of another path."""
    _height(panel)
    panel.tick(
        "closed: back to the start, and again",
        lambda document: (document["motion"]["path"] or {}).get("closed"),
        lambda closed: panel.put("motion.path.closed", closed),
    )
    chosen = Chosen(panel, "way point", lambda document: [str(i + 1) for i in range(len(points_of(document)))])
    chosen.vector(f"{PATH}[#]", "way point, m", step=0.1)
    chosen.act("Remove the way point", _without)
    chosen.act("Add a way point after it", _with_one_after)


def _height(panel: Panel) -> None:
    """Of the last point; all of them and the start are put there."""
    box = panel.gui.add_number("height, m", 0.0, step=0.1, hint="puts the start and all way points there")
    box.precision = 9

    def follow(document: Document) -> None:
        points = points_of(document)
        box.visible = bool(points) and len(points[-1]) == 3
        if box.visible:
            put(box, points[-1][2])

    by_hand(box, lambda height: panel.edit("height", _lifted(float(height))))
    panel.on_follow(follow)


def _lifted(height: float) -> Change:
    def change(scenario: Any) -> Any:
        document = scenario.to_dict()
        lifted = [[*point[:2], height] for point in points_of(document)]
        return scenario.replace({PATH: lifted, "start.position": [*document["start"]["position"][:2], height]})

    return change


def points_of(document: Document) -> list[list[float]]:
    """The points of a drawn path; none of another one."""
    points: list[list[float]] = (document["motion"]["path"] or {}).get("points", [])
    return points


def _with_one_after(index: int) -> Change:
    """One more point, half-way to the next; after the last one as far on as the way before it."""

    def change(scenario: Any) -> Any:
        points = [np.array(point) for point in points_of(scenario.to_dict())]
        here = points[index]
        if index + 1 < len(points):
            new = (here + points[index + 1]) / 2
        else:
            before = points[index - 1] if index else np.array(scenario.to_dict()["start"]["position"])
            new = 2 * here - before
        rounded = [float(f"{value:.6g}") for value in new]
        return scenario.replace({PATH: [*points[: index + 1], rounded, *points[index + 1 :]]})

    return change


def _without(index: int) -> Change:
    def change(scenario: Any) -> Any:
        points = points_of(scenario.to_dict())
        return scenario.replace({PATH: [point for i, point in enumerate(points) if i != index]})

    return change
