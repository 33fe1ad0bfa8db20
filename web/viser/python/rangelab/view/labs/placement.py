"""Where anchors should stand: a search for better places in the background, and the best place for one more."""

import json
import os
import threading
from collections.abc import Callable
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import replace
from typing import Any

import numpy as np

from ..._core import Error
from ...scenario import Scenario
from ..panel import Panel
from ..picture import Wish
from ..state import Studio
from ..values import put
from .anchors import with_anchor
from .placement_boxes import box_controls

Improved = tuple[Scenario, dict[str, Any]]
RESTARTS = 8
AT_BEST = 99.95
"""Per cent that are told as all."""

CRITERIA = (
    ("a", "A: an error in all directions"),
    ("d", "D: the volume of the ellipsoid"),
    ("e", "E: the worst direction"),
)
TARGETS = (("position", "position"), ("orientation", "orientation"), ("pose", "pose"))
PLACES = (("mean", "mean"), ("worst", "worst"))


PATIENCE = 0.1
"""How often a search looks whether it is still wanted, s."""
SCENE_CHANGED = "The scene has changed: the search was stopped."


class Search:
    """One search at a time; it ends where it is called off, and with the scene, the lab and the viewer."""

    def __init__(self, studio: Studio, told: Callable[[float, str], None]) -> None:
        self._studio, self._told = studio, told
        self._running: threading.Event | None = None
        self._best: tuple[str, float] | None = None

    def share_of_best(self, scenario: Scenario) -> str:
        """How good its anchors stand beside the best that was found; empty where nothing was."""
        value = scenario.advise()["value"]
        if self._best is None or self._best[0] != _asked_of(scenario) or not value:
            return ""
        share = 100 * self._best[1] / value
        return "You are at the best found." if share >= AT_BEST else f"You are at {share:.0f} % of the best found."

    @property
    def running(self) -> bool:
        """Whether a search goes on."""
        return self._running is not None

    def start(self, scenario: Scenario, restarts: int, found: Callable[[Improved], bool]) -> None:
        """Improves from several beginnings in the background, all of them before any anchor moves."""
        called_off = threading.Event()
        self._running = called_off
        wish = replace(self._studio.wish, source=scenario)
        self._studio.in_background("rangelab-place", lambda: self._search(wish, restarts, found, called_off))

    def cancel(self) -> None:
        """Ends the search; no anchor has moved."""
        if self._running is not None:
            self._running.set()
            self._running = None
            self._told(0.0, "Cancelled: no anchor has moved.")

    def _search(
        self, wish: Wish, restarts: int, found: Callable[[Improved], bool], called_off: threading.Event
    ) -> None:
        scenario = wish.source
        assert isinstance(scenario, Scenario)
        try:
            best = self._best_of(scenario, restarts, lambda: not called_off.is_set() and self._studio.still_asks(wish))
        except Error as error:
            best, sentence = None, str(error)
        else:
            sentence = "No better places were found."
        if called_off.is_set():
            return
        self._running = None
        if not self._studio.still_asks(wish):
            self._end_unfinished(wish)
            return
        if best is None:
            self._told(0.0, sentence)
            return
        asked = _asked_of(scenario)
        known = [self._best[1]] if self._best is not None and self._best[0] == asked else []
        self._best = asked, min([best[1]["after"], *known])
        if not found(best):
            self._told(0.0, SCENE_CHANGED)
            return
        before, after, unit = (best[1][key] for key in ("before", "after", "unit"))
        self._told(1.0, f"Improved from {value_of(before, unit)} to {value_of(after, unit)}.")

    def _end_unfinished(self, wish: Wish) -> None:
        """Says so where there still is a panel to say it."""
        if not self._studio.stopped and self._studio.wish.lab == wish.lab:
            self._told(0.0, SCENE_CHANGED)

    def _best_of(self, scenario: Scenario, restarts: int, wanted: Callable[[], bool]) -> Improved | None:
        best: tuple[float, int, Improved] | None = None
        with ThreadPoolExecutor(os.cpu_count() or 1, thread_name_prefix="rangelab") as pool:
            left: dict[Future[Improved], int] = {pool.submit(scenario.improve, n): n for n in range(restarts)}
            while left and wanted():
                done = wait(left, PATIENCE, return_when=FIRST_COMPLETED).done
                for each in done:
                    number = left.pop(each)
                    improved = each.result()
                    value, before = improved[1]["after"], improved[1]["before"]
                    if value is not None and (before is None or value < before):
                        # A tie goes to the earlier beginning, whoever ends first.
                        best = min(best or (value, number, improved), (value, number, improved), key=lambda x: x[:2])
                said = "" if best is None else f", best {value_of(best[0], best[2][1]['unit'])}"
                if done and wanted():
                    self._told(1 - len(left) / restarts, f"{restarts - len(left)} of {restarts}{said}")
            pool.shutdown(wait=False, cancel_futures=True)
        return None if best is None else best[2]


def _asked_of(scenario: Scenario) -> str:
    """All that decides what is best, without where the anchors that move happen to be."""
    document = scenario.to_dict()
    fixed, field = document["placement"]["fixed"], document["field"]
    document["anchors"] = [anchor if m in fixed else None for m, anchor in enumerate(document["anchors"])]
    document |= {"field": [field["form"], field["headings"]], "redraw_anchors": None, "name": ""}
    return json.dumps(document)


def value_of(value: float | None, unit: str) -> str:
    """In the unit in which it is read best."""
    if value is None:
        return "no bound"
    if unit == "rad":
        return f"{np.degrees(value):.3g} deg"
    return f"{1e3 * value:.3g} mm" if value < 0.1 else f"{value:.3g} m"


def placement_controls(panel: Panel) -> None:
    """The search, the best next anchor, and what counts."""
    said = panel.gui.add_markdown(
        "Anchors move within the box that they span, or the one they are given, but for those that stay."
    )
    bar = panel.gui.add_progress_bar(0.0)

    def told(share: float, sentence: str) -> None:
        put(bar, 100 * share)
        said.content = sentence

    search = Search(panel.studio, told)
    restarts = panel.gui.add_number("searches", RESTARTS, min=1, max=64, step=1)

    def improve() -> None:
        document = panel.studio.document
        if search.running:
            search.cancel()
        elif isinstance(document, Scenario):
            told(0.0, f"0 of {int(restarts.value)}")
            search.start(document, int(restarts.value), lambda best: _take(panel, document, best))

    panel.button("Improve, or cancel", improve, hint="looks for better places of the anchors")
    panel.button("Add the best next anchor", lambda: _add_best(panel, told), hint="in the plane of the bound")
    panel.note(lambda _: _share(panel, search))
    panel.tick(
        "arrows to better places",
        lambda _: panel.studio.wish.advice,
        lambda ticked: panel.studio.ask(advice=ticked),
        hint="the longest where it helps most",
    )
    panel.choice("placement.criterion", "criterion", CRITERIA)
    panel.choice("placement.target", "bound of the", TARGETS)
    panel.choice("placement.over", "places count by", PLACES)
    box_controls(panel)


def _share(panel: Panel, search: Search) -> str:
    document = panel.studio.document
    return search.share_of_best(document) if isinstance(document, Scenario) else ""


def _take(panel: Panel, asked: Scenario, best: Improved) -> bool:
    """Moves the anchors, unless the scene has changed meanwhile."""
    if panel.studio.document != asked:
        return False
    panel.edit("improved", lambda scenario: scenario.replace(anchors=best[0].anchors, redraw_anchors=None))
    return True


def _add_best(panel: Panel, told: Callable[[float, str], None]) -> None:
    document = panel.studio.document
    if not isinstance(document, Scenario):
        return
    told(0.0, "Searching the plane …")
    best = document.best_next()
    if best is None:
        told(0.0, "No place in this plane gives a bound.")
        return
    panel.edit("next anchor", with_anchor(best["point"]))
    before, after = (value_of(best[key], best["unit"]) for key in ("before", "after"))
    told(0.0, f"{before} before, {after} with one more anchor.")
