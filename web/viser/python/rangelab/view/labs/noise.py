"""How ranges are disturbed: three models, one number each."""

from typing import Any

import numpy as np

from ..panel import Document, Panel

KINDS = (("range", "of ranges"), ("squared_range", "of squared ranges"), ("toa", "of times of arrival"))


def median_range(document: Document) -> float:
    """Median distance between the body's start and the anchors, m."""
    away = np.array(document["anchors"]) - np.array(document["start"]["position"])
    return float(np.median(np.linalg.norm(away, axis=1)))


def same_noise_as(noise: Document, kind: str, distance: float) -> Document:
    """The noise of another model that disturbs a range at a distance (m) as much.

    To first order `var(r^2) = 4 r^2 var(r)`; as on the page, for r = 1 m.
    """
    if noise["kind"] == "toa":
        deviation = distance * 10 ** (-noise["zeta_db"] / 20)
    else:
        deviation = noise["sigma"] / (2 if noise["kind"] == "squared_range" else 1)
    if kind == "toa":
        return {"kind": kind, "zeta_db": float(f"{20 * np.log10(distance / deviation):.3g}")}
    return {"kind": kind, "sigma": float(f"{deviation * (2 if kind == 'squared_range' else 1):.3g}")}


def noise_controls(panel: Panel) -> None:
    """Which model, and its number."""
    panel.chooser("noise", KINDS, lambda document: str(document["noise"]["kind"]), lambda kind: _choose(panel, kind))
    panel.number("noise.sigma", "σ", step=0.01, least=0.0, hint="m for ranges, m² for squared ranges")
    panel.number("noise.zeta_db", "ζ, dB", step=1.0, hint="how far the noise lies below a range")


def _choose(panel: Panel, kind: str) -> None:
    def change(scenario: Any) -> Any:
        document = scenario.to_dict()
        return scenario.replace(noise=same_noise_as(document["noise"], kind, median_range(document)))

    panel.edit("noise", change)
