"""Boxes of the placement: where the body may be, where anchors may stand and where not; arrows to better places."""

from typing import Any

import numpy as np

from ...arrays import Floats
from .. import shapes
from ..canvas import Canvas
from ..panel import Document, Panel
from ..picture import Change
from .choices import Chosen
from .obstacles import new_obstacle

ROAMED = 0.5
"""Part of the room that the body first roams in."""
FLAT = 1e-3
"""Slopes below this part of the steepest are drawn as none."""
LONGEST = 0.11
"""Length of the longest arrow beside the scene."""
PARTS = 24
"""Edges are dashed by so many parts."""


def box_controls(panel: Panel) -> None:
    """The box of the body, that of the anchors, whose top is the ceiling, and those that are kept free."""
    _box(panel, "region", "the body is within", first_region)
    _box(panel, "limits", "anchors stand within", first_limits)
    chosen = Chosen(panel, "keep-out box", names_of)
    for end in ("low", "high"):
        chosen.vector(f"placement.keep_out[#].{end}", f"{end}, m", step=0.1)
    chosen.act("Remove the keep-out box", _without)
    panel.button("Add a keep-out box", lambda: panel.edit("keep out", _with_keep_out))


def first_region(document: Document) -> Document:
    """A box around the body, half as large as that of the anchors."""
    reach = ROAMED / 2 * np.ptp(np.array(document["anchors"]), axis=0)
    body = np.array(document["start"]["position"])
    return {"low": _rounded(body - reach), "high": _rounded(body + reach)}


def first_limits(document: Document) -> Document:
    """The box of the anchors, which limits them where nothing is said."""
    anchors = np.array(document["anchors"])
    return {"low": anchors.min(axis=0).tolist(), "high": anchors.max(axis=0).tolist()}


def names_of(document: Document) -> list[str]:
    """The keep-out boxes by their numbers."""
    return [f"keep out {i + 1}" for i in range(len(document["placement"]["keep_out"]))]


def draw_boxes(canvas: Canvas, document: Document) -> None:
    """The edges of each box, with its name at an upper corner."""
    placement, flat = document["placement"], document["dimension"] == 2
    parts = [("region", placement["region"], "accent", "body within")]
    parts.append(("limits", placement["limits"], "ink-soft", "anchors within"))
    names = names_of(document)
    parts += [(f"keep-out-{i}", box, "warning", names[i]) for i, box in enumerate(placement["keep_out"])]
    for key, box, token, name in parts:
        if box is None:
            continue
        low, high = shapes.lifted(np.array(box["low"])), shapes.lifted(np.array(box["high"]))
        corners, _, edges = shapes.box(low, high, flat=flat)
        segments = corners[edges]
        if key != "limits":
            segments = shapes.dashed(shapes.divided(segments, PARTS), 2, 1)
        canvas.lines(f"/placement/{key}", segments, token, 1.5)
        canvas.label(f"/placement/{key}-name", name, high)


def downhill(gradient: Floats, fixed: list[int]) -> Floats:
    """Where each anchor should go, the steepest of length 1; NaN for those that stay or have nothing to gain."""
    slopes = np.linalg.norm(gradient, axis=1)
    slopes[fixed] = 0.0
    steepest = slopes.max(initial=0.0)
    gains = slopes > FLAT * steepest
    return np.where(gains[:, None], -gradient / (steepest or 1.0), np.nan)


def draw_arrows(canvas: Canvas, anchors: Floats, ways: Floats) -> None:
    """An arrow from each anchor that gains."""
    moving = np.isfinite(ways).all(axis=1)
    origins, vectors = shapes.lifted(anchors[moving]), LONGEST * canvas.unit * shapes.lifted(ways[moving])
    tips = origins + vectors
    across = np.cross(vectors, [0.0, 0.0, 1.0])
    upright = np.linalg.norm(across, axis=1) < FLAT * np.linalg.norm(vectors, axis=1)
    across[upright] = np.cross(vectors[upright], [0.0, 1.0, 0.0])
    shafts = [np.stack([origins, tips], axis=1)]
    barbs = [np.stack([tips, tips - 0.25 * vectors + side * across], axis=1) for side in (0.12, -0.12)]
    canvas.lines("/placement/arrows", np.concatenate(shafts + barbs), "accent", 3.0)


def _box(panel: Panel, key: str, label: str, first: Any) -> None:
    """A box that there may be or not: a tick, and its corners."""
    path = f"placement.{key}"
    panel.tick(
        label,
        lambda document: document["placement"][key] is not None,
        lambda ticked: panel.edit(
            key, lambda scenario: scenario.replace({path: first(scenario.to_dict()) if ticked else None})
        ),
    )
    for end in ("low", "high"):
        panel.vector(f"{path}.{end}", f"… {end}, m", step=0.1)


def _with_keep_out(scenario: Any) -> Any:
    document = scenario.to_dict()
    box = new_obstacle(document, "box")
    kept = [*document["placement"]["keep_out"], {"low": box["low"], "high": box["high"]}]
    return scenario.replace({"placement.keep_out": kept})


def _without(index: int) -> Change:
    def change(scenario: Any) -> Any:
        kept = scenario.to_dict()["placement"]["keep_out"]
        return scenario.replace({"placement.keep_out": [box for i, box in enumerate(kept) if i != index]})

    return change


def _rounded(values: Floats) -> list[float]:
    return [float(f"{value:.3g}") for value in values]
