"""Walls and boxes that no range passes through: drawn, dragged, added, changed and removed."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ...arrays import Floats
from .. import shapes
from ..canvas import Canvas
from ..panel import Document, Panel
from ..picture import Change, Handle
from .choices import Chosen

PATH = "availability.obstacles"


def new_obstacle(document: Document, kind: str) -> Document:
    """Where it is seen at once: between the body and the far side of the anchors along x."""
    anchors = np.array(document["anchors"])
    least, most = anchors.min(axis=0), anchors.max(axis=0)
    middle = (document["start"]["position"][0] + most[0]) / 2

    def along(axis: int, share: float) -> float:
        return float(least[axis] + share * (most[axis] - least[axis]))

    if kind == "wall":
        ends = ([middle, along(1, 0.3)], [middle, along(1, 0.7)])
        return {"kind": kind, "from": _rounded(ends[0]), "to": _rounded(ends[1]), "bottom": None, "top": None}
    side = max(0.1, 0.1 * (most[0] - least[0]))
    low = [middle, along(1, 0.4)]
    high = [middle + side, max(along(1, 0.6), along(1, 0.4) + side)]
    if len(least) == 3:
        low, high = [*low, least[2]], [*high, max(along(2, 0.5), least[2] + side)]
    return {"kind": kind, "low": _rounded(low), "high": _rounded(high)}


def moved_by(obstacle: Document, way: Floats) -> Document:
    """An obstacle shifted by a way (D, m); a wall stays as high as it is."""
    ends = ("from", "to") if obstacle["kind"] == "wall" else ("low", "high")
    return {**obstacle, **{end: [a + b for a, b in zip(obstacle[end], way, strict=False)] for end in ends}}


def obstacle_handles(document: Document) -> list[Handle]:
    """A handle in the middle of each."""
    obstacles, d = document["availability"]["obstacles"], document["dimension"]
    names = names_of(document)
    return [_handle(i, names[i], obstacle, d, _heights(document)) for i, obstacle in enumerate(obstacles)]


def draw_obstacles(canvas: Canvas, document: Document, outline: Floats) -> None:
    """Edges, and faces that one sees through."""
    for i, obstacle in enumerate(document["availability"]["obstacles"]):
        vertices, faces, edges = mesh_of(obstacle, document["dimension"], _heights(document, outline))
        if len(faces):
            canvas.faces(f"/obstacles/{i}/faces", vertices, faces, "ink-soft", 0.3)
        canvas.lines(f"/obstacles/{i}/edges", vertices[edges], "ink-soft", 2.0)


def mesh_of(obstacle: Document, d: int, heights: tuple[float, float]) -> tuple[Floats, np.ndarray, np.ndarray]:
    """Vertices (V x 3, m), faces (F x 3) and edges (E x 2); a wall without an end goes from floor to ceiling."""
    bottom, top = heights
    if obstacle["kind"] == "wall":
        (x, y), (u, v) = obstacle["from"], obstacle["to"]
        if d == 2:
            return np.array([[x, y, 0.0], [u, v, 0.0]]), np.zeros((0, 3), np.int64), np.array([[0, 1]])
        bottom = bottom if obstacle["bottom"] is None else obstacle["bottom"]
        top = top if obstacle["top"] is None else obstacle["top"]
        corners = np.array([[x, y, bottom], [u, v, bottom], [u, v, top], [x, y, top]])
        return corners, np.array([[0, 1, 2], [0, 2, 3]]), np.array([[0, 1], [1, 2], [2, 3], [3, 0]])
    low, high = shapes.lifted(np.array(obstacle["low"])), shapes.lifted(np.array(obstacle["high"]))
    return shapes.box(low, high, flat=d == 2)


def names_of(document: Document) -> list[str]:
    """Each by its kind and number: "Wall 1", "Box 2"."""
    kinds = [obstacle["kind"] for obstacle in document["availability"]["obstacles"]]
    return [f"{'Wall' if kind == 'wall' else 'Box'} {i + 1}" for i, kind in enumerate(kinds)]


def obstacle_controls(panel: Panel) -> None:
    """Those that there are, by their numbers, and new ones."""
    chosen = Chosen(panel, "obstacle", names_of)
    for key, label in (("from", "from, m"), ("to", "to, m"), ("low", "low, m"), ("high", "high, m")):
        chosen.vector(f"{PATH}[#].{key}", label)
    for key, first in (("bottom", 0.0), ("top", 2.0)):
        chosen.optional_value(f"{PATH}[#].{key}", f"{key}, m", first=first)
    chosen.act("Remove the obstacle", _removed)
    panel.button("Add a wall", lambda: panel.edit("wall", _added("wall")))
    panel.button("Add a box", lambda: panel.edit("box", _added("box")))


def _handle(i: int, name: str, obstacle: Document, d: int, heights: tuple[float, float]) -> Handle:
    vertices, _, _ = mesh_of(obstacle, d, heights)
    middle = vertices.mean(axis=0)[:d]

    def moved(to: Floats, _: Floats) -> Change:
        return _changed(lambda found: _placed(found, i, to, d, heights))

    wall = obstacle["kind"] == "wall"
    return Handle(f"/obstacles/{i}/handle", name, middle, moved, token="ink-soft", size=0.8, fixed=(False, False, wall))


def _placed(document: Document, i: int, to: Floats, d: int, heights: tuple[float, float]) -> list[Document]:
    """The obstacles, the middle of one of them at a place."""
    obstacles: list[Document] = document["availability"]["obstacles"]
    middle = mesh_of(obstacles[i], d, heights)[0].mean(axis=0)[:d]
    return [moved_by(each, to - middle) if j == i else each for j, each in enumerate(obstacles)]


def _heights(document: Document, outline: Floats | None = None) -> tuple[float, float]:
    """Floor and ceiling of the scene, m: as far as a wall without an end is drawn."""
    points = np.array(document["anchors"]) if outline is None else outline
    known = points[np.isfinite(points).all(axis=1)]
    return (min(0.0, float(known[:, 2].min())), float(known[:, 2].max())) if known.shape[1] == 3 else (0.0, 0.0)


def _changed(obstacles: Callable[[Document], list[Document]]) -> Change:
    def change(scenario: Any) -> Any:
        return scenario.replace({PATH: obstacles(scenario.to_dict())})

    return change


def _added(kind: str) -> Change:
    return _changed(lambda found: [*found["availability"]["obstacles"], new_obstacle(found, kind)])


def _removed(index: int) -> Change:
    return _changed(lambda found: [each for i, each in enumerate(found["availability"]["obstacles"]) if i != index])


def _rounded(values: list[float]) -> list[float]:
    return [float(f"{value:.3g}") for value in values]
