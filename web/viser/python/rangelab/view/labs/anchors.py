"""Anchors by their numbers: moved, added, removed, limited in reach, held in place."""

from typing import Any

import numpy as np

from ..panel import Panel
from ..picture import Change
from ..values import by_hand, put
from .choices import Chosen


def anchor_controls(panel: Panel) -> None:
    """Where each stands, how far it reaches, whether it stays in place when others are improved."""
    chosen = Chosen(panel, "anchor", lambda document: [f"A{m + 1}" for m in range(len(document["anchors"]))])
    chosen.vector("anchors[#]", "position, m", step=0.1)
    chosen.optional(
        "reaches, m",
        lambda document: chosen.value(document, "availability.max_ranges[#]"),
        lambda value: chosen.edit(f"reach {chosen.index}", _reaching(chosen.index, value)),
        first=5.0,
    )
    stays = chosen.gui.add_checkbox("stays where it is", False, hint="when the others are improved")
    by_hand(stays, lambda value: chosen.edit("stays", _staying(chosen.index, value)))
    chosen.on_follow(lambda document: put(stays, chosen.index in document["placement"]["fixed"]))
    chosen.act("Remove the anchor", _without)
    panel.button("Add an anchor", lambda: panel.edit("anchor", with_anchor(None)))


def with_anchor(place: list[float] | None) -> Change:
    """One more anchor, in the middle of the others where no place is given."""

    def change(scenario: Any) -> Any:
        document = scenario.to_dict()
        anchors, limits = document["anchors"], document["availability"]["max_ranges"]
        there = place or [float(f"{value:.3g}") for value in np.mean(anchors, axis=0)]
        return scenario.replace(
            {
                "anchors": [*anchors, there],
                "redraw_anchors": None,
                "availability.max_ranges": [*limits, None] if limits else [],
            }
        )

    return change


def _without(index: int) -> Change:
    """The scenario without an anchor; those after it have other numbers."""

    def change(scenario: Any) -> Any:
        document = scenario.to_dict()

        def rest(values: list[Any]) -> list[Any]:
            return [each for m, each in enumerate(values) if m != index]

        fixed = [m - (m > index) for m in document["placement"]["fixed"] if m != index]
        return scenario.replace(
            {
                "anchors": rest(document["anchors"]),
                "availability.max_ranges": rest(document["availability"]["max_ranges"]),
                "placement.fixed": fixed,
            }
        )

    return change


def _reaching(anchor: int, limit: float | None) -> Change:
    """One anchor with another longest range, m; None where it has none."""

    def change(scenario: Any) -> Any:
        document = scenario.to_dict()
        known = document["availability"]["max_ranges"]
        limits = [known[m] if m < len(known) else None for m in range(len(document["anchors"]))]
        limits[anchor] = limit
        return scenario.replace({"availability.max_ranges": [] if not any(limits) else limits})

    return change


def _staying(anchor: int, stays: bool) -> Change:
    def change(scenario: Any) -> Any:
        others = {m for m in scenario.to_dict()["placement"]["fixed"] if m != anchor}
        return scenario.replace({"placement.fixed": sorted(others | {anchor} if stays else others)})

    return change
