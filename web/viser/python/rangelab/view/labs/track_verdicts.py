"""Whether filters keep what they claim, by the averages over many trials; words and thresholds are the page's."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...arrays import Floats
from ..readout import reading
from ..words import joined
from .consistency import mean_band

WRONGLY = 0.002
"""How likely a picture of consistent filters is to say anything."""


@dataclass(frozen=True)
class Means:
    """One statistic of one filter: its means over their degrees of freedom, which the steps need not share."""

    label: str
    values: Floats
    degrees: Floats
    trials: Floats
    """How many trials were averaged at each step."""


@dataclass(frozen=True)
class _Excess:
    label: str
    value: float
    edge: float
    """The end of the band there."""

    @property
    def above(self) -> bool:
        return self.value > self.edge


def verdict(nees: Sequence[Means], nis: Sequence[Means]) -> str:
    """In a sentence or two."""
    found = filter(None, [outside("NEES", nees), outside("NIS", nis)])
    return " ".join(found) or "NEES and NIS stay within what chance allows."


def outside(name: str, means: Sequence[Means]) -> str:
    """Who claims too small errors, or else too large ones: farther off than chance takes a mean of so many trials."""
    steps = len(means[0].values) if means else 0
    probability = 1 - WRONGLY / max(1, len(means) * steps)
    found = [excess for each in means if (excess := _worst(each, probability))]
    sure = [excess for excess in found if excess.above]
    if sure:
        most = max(sure, key=lambda excess: excess.value)
        named = _named(sure, means, "is too sure of itself", "are too sure of themselves")
        return f"{named}: mean {name} up to {reading(most.value)} (by chance {reading(most.edge)})."
    if not found:
        return ""
    least = min(found, key=lambda excess: excess.value)
    named = _named(found, means, "knows more than it claims", "know more than they claim")
    return f"{named}: mean {name} down to {reading(least.value)} (by chance {reading(least.edge)})."


def _worst(means: Means, probability: float) -> _Excess | None:
    """The step at which the means are farthest above the band; where none is, farthest below it."""
    found = []
    for value, degrees, trials in zip(means.values, means.degrees, means.trials, strict=True):
        if not np.isfinite(value) or trials <= 0 or not degrees > 0:
            continue
        low, high = mean_band(float(degrees), int(trials), probability)
        if not low <= value <= high:
            found.append(_Excess(means.label, float(value), high if value > high else low))
    found.sort(key=lambda excess: -excess.value)
    if not found:
        return None
    return found[0] if found[0].above else found[-1]


def _named(found: Sequence[_Excess], means: Sequence[Means], one: str, many: str) -> str:
    if len(found) == 1:
        return f"{found[0].label} {one}"
    every = len(found) == len(means) > 2
    return f"{'All filters' if every else joined([excess.label for excess in found])} {many}"
