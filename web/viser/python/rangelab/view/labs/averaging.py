"""Studies of many trials in the background: progress, an end before its time, and what they gave in the plots."""

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from ..._core import Cancelled, Error
from ...indoor import IndoorScenario
from ...jobs import Progress
from ...kinematics import KinematicsScenario
from ...scenario import Scenario
from ...studies import Study
from ..panel import Panel
from ..progress import ProgressLine
from ..study_page import StudyPage
from ..values import in_order

TRIALS = 1000
Studied = Scenario | IndoorScenario | KinematicsScenario


@dataclass(frozen=True)
class Kind:
    """One kind of study."""

    title: str
    hint: str
    run: Callable[[Any, int, Progress], Study | StudyPage]
    """Raises Cancelled, or an Error in a sentence."""
    subject: Callable[[Any], object] = lambda document: document
    """What of the document it depends on: it ends where that changes."""


AVERAGES = Kind(
    "Average over trials",
    "plots: RMSE over time, two standard errors around it",
    lambda scenario, trials, progress: scenario.study(trials, progress=progress),
)


class Averaging:
    """One study at a time of what is shown; it ends where the scene changes."""

    def __init__(self, panel: Panel) -> None:
        self._studio = panel.studio
        self._line = ProgressLine(panel.gui)
        self._running: threading.Event | None = None

    @property
    def running(self) -> bool:
        """Whether a study goes on."""
        return self._running is not None

    def start(self, kind: Kind, scenario: Studied, trials: int) -> None:
        """Runs trials in the background."""
        called_off = self._running = threading.Event()
        self._line.tell(0.0, f"{kind.title}: 0 of {trials} trials")
        self._studio.in_background("rangelab-study", lambda: self._study(kind, scenario, trials, called_off))

    def end(self) -> None:
        """Ends the study; what the trials that are done gave is shown."""
        if self._running is not None:
            self._running.set()

    def _study(self, kind: Kind, scenario: Studied, trials: int, called_off: threading.Event) -> None:
        def told(done: int, of: int) -> bool:
            if self._studio.stopped or not self._line.tell(done / of, f"{kind.title}: {done} of {of} trials"):
                return False
            return not called_off.is_set() and self._shows(kind, scenario)

        try:
            study = kind.run(scenario, trials, told)
        except (Cancelled, Error) as error:
            self._running = None
            self._line.tell(None, f"{error}".capitalize() + ".")
        else:
            in_order(self._show, kind, scenario, study)

    def _show(self, kind: Kind, scenario: Studied, study: Study | StudyPage) -> None:
        """After all edits that came before, so that a study of another scene is never shown."""
        self._running = None
        if self._studio.stopped:
            return
        if not self._shows(kind, scenario):
            self._line.tell(None, "The scene has changed: the study was stopped.")
            return
        if self._line.tell(None, "" if study.trials == study.asked else f"Stopped after {study.trials} trials."):
            self._studio.ask(study=study)

    def _shows(self, kind: Kind, scenario: Studied) -> bool:
        """Whether the document is still the one that is studied, in all that the study depends on."""
        now = self._studio.document
        if now is scenario or not isinstance(now, type(scenario)):
            return now is scenario
        return kind.subject(now) == kind.subject(scenario)


def averaging_controls(panel: Panel, kinds: Sequence[Kind] = (AVERAGES,)) -> None:
    """How many trials, start and end of each kind of study, and the single run again."""
    trials = panel.gui.add_number("trials", TRIALS, min=1, max=100_000, step=100)
    averaging = Averaging(panel)

    def toggle(kind: Kind) -> None:
        document = panel.studio.document
        if averaging.running:
            averaging.end()
        elif isinstance(document, Studied):
            averaging.start(kind, document, int(trials.value))

    for kind in kinds:
        panel.button(f"{kind.title}, or stop", partial(toggle, kind), hint=kind.hint)
    single = panel.button("Show the single run", lambda: panel.studio.ask(study=None))

    def follow(_: object) -> None:
        single.visible = panel.studio.wish.study is not None

    panel.on_follow(follow)
