"""Sizes of the eigenvalues of Gram matrices: D of them stand out and are kept, the others are noise."""

import numpy as np

from ...arrays import Floats
from ...gram_spectrum import GramSpectrum
from ..looks import Look
from ..plots import Line, Plot

ROUNDING = 1e-12
"""Below this share of the largest an eigenvalue is rounding: one is always zero, and of the truth all but D."""
EPOCH = Look("one epoch", "range", "ring", (2, 3))
FITTED = Look("fit of all", "uc-kf", "square")
TRUTH = Look("truth", "truth", "disc", (7, 4))
UNITS = ("m²", "m²/s²", "m²/s⁴")
ACCELERATIONS = 2


def spectrum_plots(spectrum: GramSpectrum, nodes: int, dimension: int, degree: int) -> list[Plot]:
    """Of the positions, and of the highest derivative that is assumed."""
    numbers = np.arange(1.0, nodes + 1)
    top = "accelerations" if degree == ACCELERATIONS else f"Y{degree}"
    unit = UNITS[degree] if degree < len(UNITS) else f"m²/s^{2 * degree}"
    positions = ((EPOCH, spectrum.epoch), (FITTED, spectrum.fitted), (TRUTH, spectrum.truth))
    derivative = ((FITTED, spectrum.fitted_top), (TRUTH, spectrum.truth_top))
    return [
        Plot(f"Spectrum: {what}, {of}", numbers, _lines(parts), axis=f"eigenvalue; {dimension} kept, last: negative")
        for what, of, parts in (("positions", "m²", positions), (top, unit, derivative))
    ]


def sizes(eigenvalues: Floats) -> Floats:
    """Their sizes, whatever their sign; NaN where they are rounding."""
    found = np.abs(eigenvalues)
    return np.where(found > ROUNDING * found.max(initial=0.0), found, np.nan)


def _lines(parts: tuple[tuple[Look, Floats], ...]) -> tuple[Line, ...]:
    shown = [(look, sizes(values)) for look, values in parts]
    return tuple(Line(look, values, 1.5) for look, values in shown if np.isfinite(values).any())
