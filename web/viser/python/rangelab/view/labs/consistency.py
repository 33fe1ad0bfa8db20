"""The bands that mean NEES and NIS lie in if covariances are right."""

from collections.abc import Iterable

from ...consistency import chi_squared_interval
from ..plots import Band

PROBABILITY = 0.95


def consistency_bands(degrees: Iterable[float], trials: int = 1) -> tuple[Band, ...]:
    """Where 95 % of the means over trials lie, over their degrees of freedom: one band for each number of them."""
    return tuple(_band(each, trials) for each in sorted(set(degrees)) if each > 0)


def mean_band(degrees: float, trials: int, probability: float) -> tuple[float, float]:
    """Where the mean of χ² over its degrees of freedom lies with a probability: trials add up their degrees."""
    freedom = degrees * trials
    low, high = chi_squared_interval(freedom, probability)
    return low / freedom, high / freedom


def _band(degrees: float, trials: int) -> Band:
    return Band(*mean_band(degrees, trials, PROBABILITY), f"95 % of χ², {round(degrees, 1):g} dof")
