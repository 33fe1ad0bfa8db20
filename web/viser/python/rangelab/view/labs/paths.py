"""What the body can follow, and what each path starts as: once round in the time of the run, within the anchors."""

from typing import Any

import numpy as np

from ...scenario import Scenario, presets
from ..panel import Document
from ..picture import Change
from ..readout import reading

PATHS = (
    ("none", "constant velocity"),
    ("turn", "turn"),
    ("figure_eight", "figure eight"),
    ("helix", "helix"),
    ("drawn", "drawn by hand"),
)
WAY_POINTS = 8
"""A first drawn path has so many points: few enough to be moved one by one."""


def with_path(kind: str) -> Change:
    """The edit to another path, without drift."""

    def change(scenario: Any) -> Any:
        motion = scenario.to_dict()["motion"]
        if kind == "none":
            return scenario.replace(motion={**motion, "path": None, **_own_velocities(scenario)})
        still = {key: [0.0] * len(motion[key]) for key in ("velocity", "angular_velocity")}
        return scenario.replace(motion={**motion, **still, "path": first_path(scenario, kind)})

    return change


def _own_velocities(scenario: Any) -> Document:
    """Those of the preset come back; a preset with a path has none that would lead anywhere."""
    name = scenario.to_dict()["name"]
    if name not in {each["name"] for each in presets()}:
        return {}
    motion = Scenario.preset(name).to_dict()["motion"]
    fits = motion["path"] is None and len(motion["velocity"]) == scenario.dimension
    return {key: motion[key] for key in ("velocity", "angular_velocity")} if fits else {}


def told(document: Document) -> str:
    """How fast the body is along its path, and how often it goes along it; nothing where it follows none."""
    path = document["motion"]["path"]
    if path is None:
        return ""
    rounds = document["interval"] * document["steps"] / path["period"]
    return (
        f"{reading(_length(document) / path['period'])} m/s, {reading(rounds)} times along it in the run. "
        "The filters are told this motion, but not what disturbs it. Velocity and turn rate: drift and spin besides."
    )


def _length(document: Document) -> float:
    """Of the path, m: of a drawn one along the straight lines between its points."""
    path, start = document["motion"]["path"], document["start"]["position"]
    if path["kind"] == "drawn":
        through = np.array([start, *path["points"], *([start] if path["closed"] else [])])
        return float(np.linalg.norm(np.diff(through, axis=0), axis=1).sum())
    level = (2 if path["kind"] == "figure_eight" else 1) * 2 * np.pi * path["radius"]
    return float(np.hypot(level, path.get("climb", 0.0)))


def first_path(scenario: Any, kind: str) -> Document:
    """A path of a size that fits the room."""
    document = scenario.to_dict()
    extents = np.ptp(np.array(document["anchors"]), axis=0)
    extents[extents == 0] = 1.0
    radius, period = _rounded(0.15 * extents[:2].min()), _rounded(document["interval"] * document["steps"])
    side = (document["motion"]["path"] or {}).get("side", "left")
    if kind == "drawn":
        return {"kind": kind, "points": _track_of(scenario), "closed": False, "period": period}
    if kind == "figure_eight":
        return {"kind": kind, "radius": radius, "period": period}
    if kind == "turn":
        return {"kind": kind, "radius": radius, "period": period, "side": side}
    climb = _rounded(0.2 * extents[-1])
    return {"kind": kind, "radius": radius, "period": _rounded(period / 2), "climb": climb, "side": side}


def _track_of(scenario: Any) -> list[list[float]]:
    """The track as it was, so that a drawn path begins with something to change."""
    track = scenario.simulate().truth_positions
    chosen = np.linspace(0, len(track) - 1, min(WAY_POINTS, len(track))).round().astype(int)
    return [[_rounded(value) for value in track[k]] for k in chosen]


def _rounded(value: float) -> float:
    return float(f"{value:.3g}")
