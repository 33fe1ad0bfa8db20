"""The colours of a field, which are those of the page in every theme."""

import numpy as np
from PIL import Image

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


FINE, PERIOD, LINE = 12, 16, 2
"""Pixels of a cell along either edge, between two lines of a hatching, and across one."""


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


def hatched(colours: Floats, values: Floats, limit: float | None, theme: Theme) -> Floats:
    """Finer, with lines where a value is above the limit, and crossed ones where there is none."""
    none = _fine(np.isnan(values).astype(np.float64)) > 0.5
    with np.errstate(invalid="ignore"):
        logs = np.log(np.where(np.isnan(values), np.nanmin(values, initial=np.inf), values))
    worse = np.zeros_like(none) if limit is None else (_fine(logs) > np.log(limit)) & ~none
    if not (worse.any() or none.any()):
        return colours
    rows, columns = np.indices(none.shape)
    rising, falling = (rows + columns) % PERIOD < LINE, (rows - columns) % PERIOD < LINE
    fine = np.stack([_fine(colours[..., i]) for i in range(3)], axis=-1)
    fine[(rising & (worse | none)) | (falling & none)] = theme.rgb("hatch")
    return fine


def _fine(values: Floats) -> Floats:
    """Each cell in FINE times FINE, the numbers between them in proportion."""
    rows, columns = values.shape
    image = Image.fromarray(values.astype(np.float32))
    return np.asarray(image.resize((FINE * columns, FINE * rows), Image.Resampling.BILINEAR), dtype=np.float64)
