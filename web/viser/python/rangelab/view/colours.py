"""The page's colours and dashes; a test holds them against its style sheet."""

import numpy as np

from ..arrays import Floats

Rgb = tuple[int, int, int]

LIGHT = {
    "anchor": "#16191f",
    "truth": "#16191f",
    "range": "#8b93a1",
    "bound": "#4b5360",
    "no-bound": "#c9ced6",
    "kf": "#aa4000",
    "ortho": "#bd8600",
    "uc-kf": "#025192",
    "et-kf": "#b467a4",
    "eskf": "#448d65",
    "eskf-raw": "#575757",
}

BOUNDS = {
    "posterior_crb": ("posterior CRB", (7, 4)),
    "posterior_crb_raw": ("posterior CRB, raw", (10, 3, 2, 3)),
    "linear_posterior_crb": ("linear posterior CRB", (2, 4)),
}
"""The bounds that plots show: their short labels and dashes."""

FIELD_STOPS = [
    "#440154",
    "#481a6c",
    "#472f7d",
    "#414487",
    "#39568c",
    "#31688e",
    "#2a788e",
    "#23888e",
    "#1f988b",
    "#22a884",
    "#35b779",
    "#54c568",
    "#7ad151",
    "#a5db36",
    "#d2e21b",
    "#fde725",
]
"""Viridis at sixteen even places: small numbers are dark."""


def rgb(token: str) -> Rgb:
    """A colour of the page as bytes."""
    return _bytes(LIGHT[token])


def _bytes(colour: str) -> Rgb:
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


def field_colours(values: Floats) -> Floats:
    """The colours of a field, bytes in the last axis: a logarithmic scale from its least to its largest value."""
    stops = np.array([_bytes(stop) for stop in FIELD_STOPS], dtype=np.float64)
    known = np.isfinite(values)
    colours = np.broadcast_to(np.array(rgb("no-bound"), dtype=np.float64), (*values.shape, 3)).copy()
    if known.any():
        logs = np.log(values[known])
        low, high = logs.min(), logs.max()
        places = (logs - low) / (high - low if high > low else 1.0) * (len(stops) - 1)
        below = np.minimum(places.astype(int), len(stops) - 2)
        share = (places - below)[:, None]
        colours[known] = stops[below] * (1 - share) + stops[below + 1] * share
    return colours
