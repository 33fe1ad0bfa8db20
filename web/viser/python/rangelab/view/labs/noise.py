"""How ranges are disturbed: three models, one number each."""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from ...arrays import Floats
from ..panel import Document, Panel
from ..readout import reading

KINDS = (("range", "of ranges"), ("squared_range", "of squared ranges"), ("toa", "of times of arrival"))


def median_range(document: Document) -> float:
    """Median distance between the body's start and the anchors, m."""
    return median_distance(np.array(document["anchors"]), np.array([document["start"]["position"]]))


def median_distance(anchors: Floats, positions: Floats) -> float:
    """Median over anchors (M x D) and positions (K x D) of the distance between them, m."""
    return float(np.median(np.linalg.norm(positions[:, None] - anchors, axis=-1)))


def same_noise_as(noise: Document, kind: str, distance: float) -> Document:
    """The noise of another model that disturbs a range at a distance (m) as much."""
    deviation = deviation_of(noise, distance)
    if kind == "toa":
        return {"kind": kind, "zeta_db": float(f"{20 * np.log10(distance / deviation):.3g}")}
    return {"kind": kind, "sigma": float(f"{deviation * (2 if kind == 'squared_range' else 1):.3g}")}


def deviation_of(noise: Document, distance: float) -> float:
    """Standard deviation of one range at a distance, m: to first order `var(r^2) = 4 r^2 var(r)`, for r = 1 m."""
    if noise["kind"] == "toa":
        return float(distance * 10 ** (-noise["zeta_db"] / 20))
    return float(noise["sigma"]) / (2 if noise["kind"] == "squared_range" else 1)


def told(noise: Document, distance: float) -> str:
    """What the number means at the median range."""
    deviation = deviation_of(noise, distance)
    below = "" if deviation == 0 else f", {reading(20 * float(np.log10(distance / deviation)))} dB below it"
    return f"{reading(deviation)} m on the median range of {reading(distance)} m{below}"


def noise_controls(panel: Panel, distance_of: Callable[[Document], float] = median_range) -> None:
    """Which model, its number, and what that is at the median range, m."""
    panel.chooser("noise", KINDS, lambda document: str(document["noise"]["kind"]), partial(_choose, panel, distance_of))
    panel.number("noise.sigma", "σ", step=0.01, least=0.0, hint="m for ranges, m² for squared ranges")
    panel.number("noise.zeta_db", "ζ, dB", step=1.0, hint="how far the noise lies below a range")
    panel.note(lambda document: told(document["noise"], distance_of(document)))


def _choose(panel: Panel, distance_of: Callable[[Document], float], kind: str) -> None:
    def change(scenario: Any) -> Any:
        document = scenario.to_dict()
        return scenario.replace(noise=same_noise_as(document["noise"], kind, distance_of(document)))

    panel.edit("noise", change)
