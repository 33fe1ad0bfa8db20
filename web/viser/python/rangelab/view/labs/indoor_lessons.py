"""Where differences between indoor filters come from, in sentences: those of the page."""

from collections.abc import Sequence

import numpy as np

from ..panel import DEGREES
from ..readout import reading
from .findings import Finding, count_of
from .indoor_levels import Level

TELLING = 0.005
"""Less than this share is no difference worth a word."""
SAME = 1e-3
"""Filters whose errors differ by a smaller share are said to do the same."""
MOST_DIGITS = 6
FAR, LOST = 1.5, 10.0
"""So many times better or worse is a matter of the integration, not of chance; so many times worse a filter is lost."""
WORSE = 1.02
"""An orientation that is so many times worse is worth a word."""
WRONG, RIGHT = 4.0, 1.5
"""Times the claimed square of the error from which a claim is plainly wrong, and up to which it is plainly right."""
EULER = ("ekf-rie", "ekf-retraction", "ukf-rie", "ekf", "ekf-full", "ukf")
EXACT = ("mekf", "tight", "lie-kf")
Levels = Sequence[Level]


def lessons(levels: Levels, convention: str) -> list[Finding | None]:
    """In the order in which they are read."""
    if not levels:
        return [Finding("No filter is switched on.", 100)]
    differences = _agreement(levels) or [
        _growth(levels),
        _gain(levels),
        _integration(levels, convention),
        _turn(levels),
    ]
    return [*differences, _consistency(levels), _nearest(levels)]


def _pick(levels: Levels, *names: str) -> Level | None:
    return next((level for name in names for level in levels if level.name == name), None)


def _apart(one: float, other: float) -> float:
    return abs(one / other - 1)


def _agreement(levels: Levels) -> list[Finding | None]:
    """Where all do the same there is nothing to explain but that."""
    if len(levels) == 1 or any(_apart(level.position, levels[0].position) > TELLING for level in levels):
        return []
    still = all(level.stretch - 1 < TELLING for level in levels)
    why = "hardly anything turns, so R stays a rotation by itself" if still else "the ranges decide alone"
    return [Finding(f"All filters agree to half a per cent: {why}.", 90)]


def _growth(levels: Levels) -> Finding | None:
    """Euler's rule makes R longer with every turn."""
    most = max(level.stretch for level in levels)
    grown = next(level for level in levels if _apart(level.stretch, most) < TELLING)
    if most - 1 < TELLING:
        return None
    return Finding(f"{grown.label}’s R has grown by {grown.stretch:.3f}, and its accelerations R a with it.", 85)


def _gain(levels: Levels) -> Finding | None:
    """What EKFRie gains, and whether retraction alone gains it too."""
    plain, manifold, bare = (_pick(levels, name) for name in ("ekf", "ekf-rie", "ekf-retraction"))
    if plain is None or manifold is None:
        return None
    telling = _apart(plain.position, manifold.position) >= TELLING
    how = "" if bare is None else _alone(bare, manifold, telling=telling)
    return Finding(f"EKFRie is {_compared(manifold.position, plain.position)} EKF{how}.", 80)


def _compared(mine: float, other: float) -> str:
    """As in "9 % better than", "5 times as good as"."""
    ratio = other / mine
    if abs(ratio - 1) < TELLING:
        return "as good as"
    if ratio >= 2:
        return f"{_times(ratio)} times as good as"
    if ratio <= 0.5:
        return f"{_times(1 / ratio)} times as bad as"
    percent = max(1, round(100 * abs(mine / other - 1)))
    return f"{percent} % {'better' if ratio > 1 else 'worse'} than"


def _alone(bare: Level, manifold: Level, *, telling: bool) -> str:
    """How much of it retraction does without transport; `telling` where there is something to do."""
    difference = _apart(bare.position, manifold.position)
    if difference >= SAME:
        return f"; retraction alone is {_compared(bare.position, manifold.position)} it"
    digits = min(MOST_DIGITS, int(np.floor(-np.log10(max(difference, 1e-12)))))
    equals = f"alone equals it to {count_of(digits)} digits"
    return f", all by retraction: that {equals}" if telling else f"; retraction {equals}"


def _integration(levels: Levels, convention: str) -> Finding | None:
    """What an integrator that fits the samples does, or one that does not."""
    euler, exact = _pick(levels, *EULER), _pick(levels, *EXACT)
    if euler is None or exact is None:
        return None
    ratio, metres = euler.position / exact.position, f"{reading(exact.position)} m"
    if ratio > FAR:
        who = "whose integration matches ‘mean’ samples" if convention == "mean" else "which integrates exactly"
        text = f"{exact.label}, {who}, is {_times(ratio)} times as good: {metres}."
        return Finding(text, 84 if ratio > LOST else 75)
    if ratio < 1 / FAR:
        disc = "‘disc’ samples match Euler’s rule, not its integration"
        why = disc if convention == "disc" else "the samples match Euler’s rule better"
        return Finding(f"{exact.label} is {_times(1 / ratio)} times as bad ({metres}): {why}.", 82)
    return None


def _times(ratio: float) -> str:
    return f"{ratio:.1f}".removesuffix(".0") if ratio < 10 else str(round(ratio))


def _turn(levels: Levels) -> Finding | None:
    """Where the Q-factor turns less well than Euler's rule and a polar factor at the end."""
    plain, manifold = _pick(levels, "ekf"), _pick(levels, "ekf-rie")
    if plain is None or manifold is None or manifold.angle / plain.angle < WORSE:
        return None
    text = f"EKFRie’s orientation is worse: {_degrees(manifold)} against {_degrees(plain)}."
    return Finding(text, 83 if manifold.angle / plain.angle > FAR else 60)


def _consistency(levels: Levels) -> Finding | None:
    wrong = [level for level in levels if level.nees > WRONG]
    honest = [level for level in levels if 1 / RIGHT < level.nees < RIGHT]
    if honest and wrong:
        return Finding(f"{honest[0].label} is off by what it claims: NEES {honest[0].nees:.2f} of 1.", 65)
    if not wrong or len(wrong) < len(levels):
        return None
    least = _times(min(level.nees for level in wrong))
    return Finding(
        f"All claim too much: squared errors are {least} times the claim and more; P knows the noise only.", 40
    )


def _nearest(levels: Levels) -> Finding:
    best = min(levels, key=lambda level: level.position)
    return Finding(f"Nearest: {best.label}, {reading(best.position)} m and {_degrees(best)}.", 30)


def _degrees(level: Level) -> str:
    return f"{reading(DEGREES * level.angle)}°"
