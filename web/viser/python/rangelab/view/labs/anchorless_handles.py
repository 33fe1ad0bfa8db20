"""What is dragged and typed in the Anchorless lab: nodes and their arrows, where the gauge shows them."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Floats
from ...kinematics import KinematicsScenario
from ..panel import Document
from ..picture import Change, Handle
from .anchorless_hints import reach
from .gauge import gauge_of, seen

CLEAN = 9
"""Digits after the point that are kept of derivatives, as on the page: a turn and back is not noise."""


def handles_of(document: Document) -> list[Handle]:
    """The nodes at time 0, and the tips of their velocities."""
    places, *derivatives = seen(document)
    nodes = [Handle(f"/anchors/{n}", f"N{n + 1}", place, _moved(n), size=0.7) for n, place in enumerate(places)]
    if not derivatives:
        return nodes
    tips = places + reach(document, 1) * derivatives[0]
    return [*nodes, *(Handle(f"/velocities/{n}", "", tip, _pulled(n, 1), size=0.4) for n, tip in enumerate(tips))]


def with_vector(order: int, n: int, vector: ArrayLike) -> Change:
    """The edit of a node: its place (m), or one of its derivatives (m/s^l), given as it is seen."""

    def change(scenario: KinematicsScenario) -> KinematicsScenario:
        document, given = scenario.to_dict(), np.asarray(vector, dtype=np.float64)
        gauge = gauge_of(document)
        # What is taken in a hand and not moved keeps its numbers: there and back through the gauge rounds.
        if np.array_equal(given, seen(document)[order, n]):
            return scenario
        if order > 0:
            given = np.round(gauge.turned_back(given), CLEAN) + 0.0
        elif not gauge.is_identity:
            given = gauge.placed_back(given)
        return scenario.replace({f"coefficients[{order}][{n}]": given})

    return change


def _moved(n: int) -> Callable[[Floats, Floats], Change]:
    return lambda to, _: with_vector(0, n, to)


def _pulled(n: int, order: int) -> Callable[[Floats, Floats], Change]:
    """The derivative of a node whose arrow has its tip where the hand is."""

    def moved(to: Floats, _: Floats) -> Change:
        def change(scenario: KinematicsScenario) -> KinematicsScenario:
            document = scenario.to_dict()
            vector = (to - seen(document)[0][n]) / reach(document, order)
            changed = with_vector(order, n, vector)(scenario)
            assert isinstance(changed, KinematicsScenario)
            return changed

        return change

    return moved
