"""What the trials of the localizers show, in a few sentences."""

import numpy as np

from ...arrays import Floats
from ..looks import LOCALIZER_BOUNDS, LOCALIZERS
from ..readout import reading, root_mean_square
from ..words import joined

ON_RAW_RANGES = ("gauss-newton", "maximum-likelihood")
OFTEN = 0.01
"""Fewer mirrored bodies than this share are an accident."""
AT_BOUND = 1.1
"""A localizer this near its bound is at it."""
MOST_NAMES = 3
"""More names than these are counted instead."""

Pairs = dict[str, tuple[float, float]]
"""Angle (rad) and position (m) by name; NaN where there is none."""


def bound_of(name: str) -> str:
    """The bound for what a localizer knows."""
    return {"classical-ls": "classical_crb", "ls": "crb"}.get(name, "uc_crb_raw" if name in ON_RAW_RANGES else "uc_crb")


def nearest(angles: dict[str, Floats], positions: dict[str, Floats], bounds: Pairs, trials: int) -> str:
    """The localizer with the least error of the orientation, beside the bound for what it knows."""
    found = {name: (root_mean_square(angles[name]), root_mean_square(positions[name])) for name in angles}
    known = {name: pair for name, pair in found.items() if np.isfinite(pair).all()}
    if not known:
        return ""
    best = min(known, key=lambda name: known[name][0])
    over = f"Over {trials} trials {LOCALIZERS[best].label} is nearest: {_errors(known[best])} off"
    of = bound_of(best)
    least = bounds.get(of, (np.nan, np.nan))
    if not np.isfinite(least).all():
        return f"{over}; no bound exists here."
    ratio = known[best][0] / least[0]
    verdict = "it is at its bound" if ratio < AT_BOUND else f"{reading(ratio)} times its bound in orientation"
    return f"{over}; {verdict} ({LOCALIZER_BOUNDS[of].label}: {_errors(least)})."


def mirroring(rates: dict[str, float]) -> str:
    """Who mirrors the body, by the share of the trials."""
    often = {name: rate for name, rate in rates.items() if rate >= OFTEN}
    if not often:
        return ""
    least, most = (reading(100 * rate) for rate in (min(often.values()), max(often.values())))
    share = f"{most} %" if least == most else f"{least} to {most} %"
    return f"{_names(list(often))} {'mirrors' if len(often) == 1 else 'mirror'} the body in {share} of the trials."


def failing(failures: dict[str, list[str]], trials: int) -> str:
    """Who gave nothing in how many trials, and why."""
    failed = {name: reasons for name, reasons in failures.items() if reasons}
    if not failed:
        return ""
    first = next(iter(failed.values()))
    verb = "has" if len(failed) == 1 else "have"
    return f"{_names(list(failed))} {verb} no estimate in {len(first)} of {trials} trials: {first[0]}"


def _names(names: list[str]) -> str:
    if len(names) > MOST_NAMES:
        return f"{len(names)} localizers"
    return joined([LOCALIZERS[name].label for name in names])


def _errors(pair: tuple[float, float]) -> str:
    return f"{reading(float(np.degrees(pair[0])))}° and {reading(pair[1])} m"
