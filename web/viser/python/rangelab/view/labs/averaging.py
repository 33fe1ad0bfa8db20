"""Monte-Carlo in the background: progress, an end before its time, and its averages in the plots."""

import threading

from ..._core import Cancelled, Error
from ...indoor import IndoorScenario
from ...scenario import Scenario
from ...studies import Study
from ..panel import Panel
from ..values import in_order, put

TRIALS = 1000
Studied = Scenario | IndoorScenario


class Averaging:
    """One study at a time of what is shown; it ends where the scene changes."""

    def __init__(self, panel: Panel) -> None:
        self._studio = panel.studio
        self._said = panel.gui.add_markdown("", visible=False)
        self._bar = panel.gui.add_progress_bar(0.0, visible=False)
        self._running: threading.Event | None = None

    @property
    def running(self) -> bool:
        """Whether a study goes on."""
        return self._running is not None

    def start(self, scenario: Studied, trials: int) -> None:
        """Runs trials in the background."""
        called_off = self._running = threading.Event()
        self._tell(0.0, f"0 of {trials} trials")
        threading.Thread(
            target=self._study, args=(scenario, trials, called_off), name="rangelab-study", daemon=True
        ).start()

    def end(self) -> None:
        """Ends the study; the averages of the trials that are done are shown."""
        if self._running is not None:
            self._running.set()

    def _study(self, scenario: Studied, trials: int, called_off: threading.Event) -> None:
        def told(done: int, of: int) -> bool:
            if self._studio.stopped:
                return False
            self._tell(done / of, f"{done} of {of} trials")
            return not called_off.is_set() and self._studio.document is scenario

        try:
            study = scenario.study(trials, progress=told)
        except (Cancelled, Error) as error:
            self._running = None
            self._tell(None, f"{error}".capitalize() + ".")
        else:
            in_order(self._show, scenario, study)

    def _show(self, scenario: Studied, study: Study) -> None:
        """After all edits that came before, so that averages of another scene are never shown."""
        self._running = None
        if self._studio.stopped:
            return
        if self._studio.document is not scenario:
            self._tell(None, "The scene has changed: the study was stopped.")
            return
        self._tell(None, "" if study.trials == study.asked else f"Stopped after {study.trials} trials.")
        self._studio.ask(study=study)

    def _tell(self, share: float | None, sentence: str) -> None:
        self._bar.visible = share is not None
        if share is not None:
            put(self._bar, 100 * share)
        self._said.visible = bool(sentence)
        self._said.content = sentence


def averaging_controls(panel: Panel) -> None:
    """How many trials, start and end, and the single run again."""
    trials = panel.gui.add_number("trials", TRIALS, min=1, max=100_000, step=100)
    averaging = Averaging(panel)

    def toggle() -> None:
        document = panel.studio.document
        if averaging.running:
            averaging.end()
        elif isinstance(document, Studied):
            averaging.start(document, int(trials.value))

    panel.button("Average over trials, or stop", toggle, hint="plots: RMSE over time, two standard errors around it")
    single = panel.button("Show the single run", lambda: panel.studio.ask(study=None))

    def follow(_: object) -> None:
        single.visible = panel.studio.wish.study is not None

    panel.on_follow(follow)
