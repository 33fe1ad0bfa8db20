"""Lines along which a field has one value, at round values."""

from dataclasses import dataclass

import numpy as np

from ..arrays import Floats

DIGITS = (
    (1, 2, 5),
    (1, 1.5, 2, 3, 4, 5, 7),
    (1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3, 3.5, 4, 4.5, 5, 6, 7, 8, 9),
    tuple((10 + i) / 10 for i in range(90)),
)
"""First digits of levels, from few to many in a power of ten."""
LEAST, MOST = 4, 12
"""With fewer levels one does not see which way the numbers grow, with more one sees nothing else."""
LABELLED = 0.25
"""Lines longer than this share of the shorter edge have a label."""
LABELS_TOWARDS = (0.7, 0.25)
"""Labels stand where lines are nearest to this place (along a row, from row to row; both 0 to 1)."""

APART = 0.1
"""Labels are no nearer to each other, beside the picture."""


@dataclass(frozen=True)
class Levels:
    """Round values in the unit that is shown: those of the field times the factor."""

    values: tuple[float, ...]
    unit: str
    factor: float

    @classmethod
    def of(cls, field: Floats, unit: str, factor: float) -> "Levels":
        """Those between the least and the largest number of a field."""
        known = factor * field[np.isfinite(field)]
        return cls(tuple(round_levels(known.min(), known.max())) if len(known) else (), unit, factor)


def round_levels(low: float, high: float) -> list[float]:
    """From `low` to `high` 1, 2 and 5 times the powers of ten; finer ones where these are few, else powers of ten."""
    powers = range(int(np.floor(np.log10(low))), int(np.ceil(np.log10(high))) + 1)

    def within(digits: tuple[float, ...]) -> list[float]:
        every = [float(f"{digit}e{power}") for power in powers for digit in digits]
        return [value for value in every if low * (1 - 1e-9) <= value <= high * (1 + 1e-9)]

    fitting = [found for found in map(within, DIGITS) if len(found) <= MOST]
    if not fitting:
        tens = within((1,))
        return tens[:: -(-len(tens) // MOST)]
    return next((found for found in fitting if len(found) >= LEAST), fitting[-1])


def crossings(logs: Floats, levels: Levels) -> np.ndarray:
    """For each place of a fine grid of logarithms the number of the level that is crossed there from 1 on, else 0."""
    at = np.log(np.array(levels.values) / levels.factor)
    above = np.searchsorted(at, logs)
    found = np.zeros(logs.shape, dtype=int)
    for axis in (0, 1):
        low, high = np.delete(above, -1, axis), np.delete(above, 0, axis)
        known = ~np.isnan(np.delete(logs, -1, axis) + np.delete(logs, 0, axis))
        inside: tuple[slice, ...] = tuple(slice(None, -1) if i == axis else slice(None) for i in (0, 1))
        found[inside] = np.where(known & (low != high), np.maximum(low, high), found[inside])
    return found


def label_places(crossed: np.ndarray, levels: Levels) -> list[tuple[str, float, float]]:
    """What is written where: along a row and from row to row, both 0 to 1."""
    rows, columns = crossed.shape
    found: list[tuple[str, float, float]] = []
    for number, value in enumerate(levels.values, 1):
        j, i = np.nonzero(crossed == number)
        if len(i) < LABELLED * min(rows, columns):
            continue
        u, v = (i + 0.5) / columns, (j + 0.5) / rows
        for _, other_u, other_v in found:
            free = np.hypot(u - other_u, v - other_v) > APART
            u, v = u[free], v[free]
        if len(u):
            nearest = int(np.argmin((u - LABELS_TOWARDS[0]) ** 2 + (v - LABELS_TOWARDS[1]) ** 2))
            found.append((f"{value:g} {levels.unit}", float(u[nearest]), float(v[nearest])))
    return found
