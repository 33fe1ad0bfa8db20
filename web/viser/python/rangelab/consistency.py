"""Whether covariances are right: the bands that NEES and NIS are held against."""

from . import _core


def chi_squared_interval(degrees_of_freedom: float, probability: float = 0.95) -> tuple[float, float]:
    """Both numbers that chi-square stays between with a probability, as much of the rest below as above.

    The mean over T trials of a NEES with n degrees of freedom lies between `low / T` and `high / T` of the interval
    with `T * n` degrees.

    Raises:
        Error: for degrees of freedom that are not from 1 to 1e9, or a probability that is not between 0 and 1.

    >>> low, high = chi_squared_interval(6)
    >>> round(low, 3), round(high, 3)
    (1.237, 14.449)

    """
    return _core.chi_squared_interval(degrees_of_freedom, probability)
