"""What a trial of the Anchorless lab shows, or averages over many, in sentences: those of the page."""

from collections.abc import Iterable, Mapping, Sequence

from ...kinematics_run import KinematicsRun
from ..looks import KINEMATICS
from ..readout import reading
from ..words import start_of
from .anchorless_levels import Level, Report, levels_of_run
from .findings import Finding, as_sentence, count_of, weightiest

AT_BOUND = 1.15
"""An average this near its bound is at it."""
TELLING = 1.15
"""So many times better is worth a sentence."""
A_TURN = 3.0
"""An error that shrinks this many times when it is aligned anew was a turn of the whole network."""
VELOCITY, ACCELERATION = 1, 2
BEYOND_CHANCE = 5.0
"""Errors of one trial differ by chance, but not this much."""
Levels = Sequence[Level]
Bounds = Mapping[str, Sequence[float]]


def described(run: KinematicsRun, bounds: Bounds) -> str:
    """What one trial shows: what is no matter of chance."""
    if not run.estimators:
        return "No estimator is switched on."
    levels = levels_of_run(run, bounds)
    return weightiest([_failing(run), _drowning(run), _farthest(levels), _turning(levels), _bought(bounds, levels)])


def judged(report: Report, where: str) -> str:
    """What averages show, and how sure they are; `where` says what they are of."""
    levels = report.levels
    if not levels:
        return "No estimator that finds a motion is switched on."
    bounds = {kind: report.coefficients(kind) for kind in report.bounds}
    at = start_of(f"{where}, {report.trials} trials")
    return weightiest([_paper_beaten(levels), _nearest(levels, at), _turning(levels), _bought(bounds, levels)])


def _failing(run: KinematicsRun) -> Finding | None:
    """The first estimator that gave nothing, and why: the others go on."""
    failed = [(KINEMATICS[name].label, each.failure) for name, each in run.estimators.items() if each.failure]
    if not failed:
        return None
    (label, why), *others = failed
    more = f" (and {count_of(len(others))} more)" if others else ""
    return Finding(f"{label}{more} gives nothing: {as_sentence(why)}", 100)


def _drowning(run: KinematicsRun) -> Finding | None:
    """Algorithm 1 reads accelerations from the last coefficient of the Gram matrix, which may be noise."""
    margins = {name: each.acceleration_margin for name, each in run.estimators.items()}
    drowned = [
        (KINEMATICS[name].label, margin) for name, margin in margins.items() if margin is not None and margin < 1
    ]
    if not drowned:
        return None
    label, margin = drowned[0]
    text = f"{label}: the accelerations drown, their least eigenvalue is {reading(margin)} times that of noise."
    return Finding(text, 80)


def _paper_beaten(levels: Levels) -> Finding | None:
    """The paper's claim that accelerometers are needed, against distances used well."""
    distances = _best(each for each in levels if not each.senses)
    second = _best(each for each in levels if each.name.startswith("algorithm-2"))
    if distances is None or second is None:
        return None
    ratio = second.errors[VELOCITY] / distances.errors[VELOCITY]
    one, other, far = distances.label, second.label, reading(max(ratio, 1 / ratio))
    if ratio > TELLING:
        return Finding(f"Without accelerometers {one} finds velocities {far} times better than {other} with them.", 70)
    if 1 / ratio > TELLING:
        return Finding(f"{other} finds velocities {far} times better than the best from distances, {one}.", 60)
    return None


def _best(levels: Iterable[Level]) -> Level | None:
    """In velocity."""
    known = (each for each in levels if len(each.errors) > VELOCITY)
    return min(known, key=lambda each: each.errors[VELOCITY], default=None)


def _nearest(levels: Levels, where: str) -> Finding | None:
    """The estimator nearest to its own bound in the velocities, and the farthest one."""
    known = [(ratio, each) for each in levels if (ratio := each.over_bound(VELOCITY)) is not None]
    if not known:
        return None
    rated = sorted(known, key=lambda each: each[0])
    (ratio, first), (_, last) = rated[0], rated[-1]
    if ratio < AT_BOUND:
        near = f"{first.label} is at its bound in velocity ({_times(first, ratio)})"
    else:
        near = f"{first.label} is {_times(first, ratio)} its bound in velocity"
    far = "" if first is last else f", {last.label} {_times(last, rated[-1][0])}"
    return Finding(f"{where}: {near}{far}.", 65)


def _times(level: Level, ratio: float) -> str:
    if level.standard_errors is None:
        return f"{reading(ratio)} ×"
    spread = level.standard_errors[VELOCITY] * ratio / level.errors[VELOCITY]
    return f"{reading(ratio)} ± {reading(spread)} ×"


def _farthest(levels: Levels) -> Finding | None:
    """The largest difference between two estimators in one trial, where it is larger than chance makes it."""
    found = [
        _difference(levels, order, what) for order, what in ((VELOCITY, "velocity"), (ACCELERATION, "acceleration"))
    ]
    ratio, text = max(found, key=lambda each: each[0])
    return Finding(text, 60) if ratio > BEYOND_CHANCE else None


def _difference(levels: Levels, order: int, what: str) -> tuple[float, str]:
    """How many times as much the worst errs as the best, and the sentence of it."""
    known = sorted(
        (each for each in levels if len(each.errors) > order and each.errors[order] > 0),
        key=lambda each: each.errors[order],
    )
    if not known:
        return 0.0, ""
    best, worst = known[0], known[-1]
    ratio = worst.errors[order] / best.errors[order]
    return ratio, f"{worst.label} errs {reading(ratio)} times as much in {what} as {best.label}."


def _turning(levels: Levels) -> Finding | None:
    """What grows away from time 0 is one turn of the whole network, where aligning anew takes it away."""
    turned = [each for each in levels if each.last[0] > A_TURN * each.last[1]]
    if not turned:
        return None
    most = max(turned, key=lambda each: each.last[0] / each.last[1])
    one, aligned = (reading(each) for each in most.last)
    text = f"At the end {most.label} is {one} m off, but {aligned} m once aligned there: most of it is one turn of all."
    return Finding(text, 50)


def _bought(bounds: Bounds, levels: Levels) -> Finding | None:
    """What accelerometers could give at most, by the bounds."""
    sensed, without = bounds.get("accelerometers", ()), bounds.get("distances", ())
    if not any(each.senses for each in levels) or min(len(sensed), len(without)) <= ACCELERATION:
        return None
    position, velocity, acceleration = (reading(without[order] / sensed[order]) for order in range(3))
    return Finding(
        f"By the bounds accelerometers buy {position} × in position, {velocity} × in velocity, "
        f"{acceleration} × in acceleration.",
        40,
    )
