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
INK = 0.75
"""How dark the lines of round values are."""


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


def fine_logs(values: Floats) -> Floats:
    """Logarithms of a finer field; NaN near where there is none."""
    none = _fine(np.isnan(values).astype(np.float64)) > 0
    logs = _fine(np.log(np.where(np.isnan(values), np.nanmin(values, initial=np.inf), values)))
    return np.where(none, np.nan, logs)


def lined(colours: Floats, lines: np.ndarray, theme: Theme) -> Floats:
    """Finer, with lines (a fine grid of yes and no), two pixels wide."""
    if not lines.any():
        return colours
    fine = colours if colours.shape[:2] == lines.shape else _fine_colours(colours)
    wide = lines | np.roll(lines, 1, axis=0) | np.roll(lines, 1, axis=1)
    fine[wide] = INK * np.array(theme.rgb("truth")) + (1 - INK) * fine[wide]
    return fine


def hatched(colours: Floats, values: Floats, limit: float | None, theme: Theme) -> Floats:
    """Finer, with lines where a value is above the limit, and crossed ones where there is none."""
    none = _fine(np.isnan(values).astype(np.float64)) > 0.5
    with np.errstate(invalid="ignore"):
        worse = np.zeros_like(none) if limit is None else (fine_logs(values) > np.log(limit)) & ~none
    if not (worse.any() or none.any()):
        return colours
    rows, columns = np.indices(none.shape)
    rising, falling = (rows + columns) % PERIOD < LINE, (rows - columns) % PERIOD < LINE
    fine = _fine_colours(colours)
    fine[(rising & (worse | none)) | (falling & none)] = theme.rgb("hatch")
    return fine


def _fine_colours(colours: Floats) -> Floats:
    return np.stack([_fine(colours[..., i]) for i in range(3)], axis=-1)


def _fine(values: Floats) -> Floats:
    """Each cell in FINE times FINE, the numbers between them in proportion."""
    rows, columns = values.shape
    image = Image.fromarray(values.astype(np.float32))
    return np.asarray(image.resize((FINE * columns, FINE * rows), Image.Resampling.BILINEAR), dtype=np.float64)
