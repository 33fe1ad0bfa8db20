"""The colours of a field, which are those of the page in every theme."""

import numpy as np

from ..arrays import Floats
from .themes import Theme, bytes_of

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


def field_colours(values: Floats, theme: Theme) -> Floats:
    """The colours of a field, bytes in the last axis: a logarithmic scale from its least to its largest value."""
    stops = np.array([bytes_of(stop) for stop in FIELD_STOPS], dtype=np.float64)
    known = np.isfinite(values)
    colours = np.broadcast_to(np.array(theme.rgb("no-bound"), dtype=np.float64), (*values.shape, 3)).copy()
    if known.any():
        logs = np.log(values[known])
        low, high = logs.min(), logs.max()
        places = (logs - low) / (high - low if high > low else 1.0) * (len(stops) - 1)
        below = np.minimum(places.astype(int), len(stops) - 2)
        share = (places - below)[:, None]
        colours[known] = stops[below] * (1 - share) + stops[below + 1] * share
    return colours
