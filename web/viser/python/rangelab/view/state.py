"""What is shown: a scenario or recording, its run, its field; recomputed behind the edits, newest first."""

import threading
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from .._core import Error
from ..arrays import Floats
from ..field import Field
from ..recording import Recording
from ..run import Run
from ..scenario import Scenario
from .source import Source


@dataclass(frozen=True)
class Wish:
    """What is to be computed."""

    source: Source
    trial: int = 0
    estimators: tuple[str, ...] | None = None
    """Those that run over a recording; a scenario says so itself."""
    field: bool = False


@dataclass(frozen=True)
class Shown:
    """A wish and what came of it."""

    wish: Wish
    run: Run
    field: Field | None

    @property
    def extent(self) -> float:
        """How large the scene is, m."""
        points = [self.run.anchors, self.run.truth_positions]
        known = np.concatenate([p[np.isfinite(p).all(axis=1)] for p in points])
        size: Floats = np.ptp(known, axis=0)
        return float(size.max()) or 1.0


FIELD_CELLS = 48


def computed(wish: Wish) -> Shown:
    """Runs the crate.

    Raises:
        Error: in a sentence.
    """
    source = wish.source
    if isinstance(source, Recording):
        settings = {} if wish.estimators is None else {"enabled": list(wish.estimators)}
        return Shown(wish, source.run(settings), None)
    field = source.field(FIELD_CELLS) if wish.field else None
    return Shown(wish, source.run(wish.trial), field)


class Studio:
    """Takes edits from any thread and computes the newest; what came in between is left out.

    `show` hears what was computed, `refuse` the sentence of an edit that cannot be; the last good state stays.
    """

    def __init__(self, wish: Wish, show: Callable[[Shown], None], refuse: Callable[[str], None]) -> None:
        self._show, self._refuse = show, refuse
        self._lock = threading.Lock()
        self._changed = threading.Condition(self._lock)
        self._wish, self._pending = wish, False
        self._stopped = False
        self.good = computed(wish)
        self._thread = threading.Thread(target=self._work, name="rangelab-view", daemon=True)
        self._thread.start()

    @property
    def wish(self) -> Wish:
        """What was asked for last."""
        with self._lock:
            return self._wish

    @property
    def scenario(self) -> Scenario | None:
        """The scenario, where it is none of a recording."""
        source = self.wish.source
        return source if isinstance(source, Scenario) else None

    def edit(self, change: Callable[[Scenario], Scenario]) -> None:
        """Changes the scenario; a change that its rules forbid is refused and changes nothing."""
        try:
            with self._changed:
                if isinstance(self._wish.source, Scenario):
                    self._wish = replace(self._wish, source=change(self._wish.source))
                    self._pending = True
                    self._changed.notify()
        except Error as error:
            self._refuse(str(error))

    def ask(self, **changes: object) -> None:
        """Changes another part of the wish."""
        with self._changed:
            self._wish = replace(self._wish, **changes)  # type: ignore[arg-type]
            self._pending = True
            self._changed.notify()

    def stop(self) -> None:
        """Ends the thread."""
        with self._changed:
            self._stopped = True
            self._changed.notify()
        self._thread.join()

    def _work(self) -> None:
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._pending or self._stopped)
                if self._stopped:
                    return
                wish, self._pending = self._wish, False
            try:
                self.good = computed(wish)
            except Error as error:
                with self._lock:
                    if self._wish is wish:
                        self._wish = self.good.wish
                self._refuse(str(error))
            else:
                self._show(self.good)
