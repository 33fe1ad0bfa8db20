"""What is shown: a document and what the crate makes of it; recomputed behind the edits, newest first, with undo."""

import threading
from collections.abc import Callable
from dataclasses import replace

from .._core import Error
from ..recording import Recording
from .history import History
from .picture import Change, Document, Picture, Wish


class Studio:
    """Takes edits from any thread and computes the newest; what came in between is left out.

    `show` hears what was computed, `refuse` the sentence of an edit that cannot be; the last good state stays.
    """

    def __init__(
        self,
        wish: Wish,
        compute: Callable[[Wish], Picture],
        show: Callable[[Picture], None],
        refuse: Callable[[str], None],
    ) -> None:
        self._compute, self._show, self._refuse = compute, show, refuse
        self._changed = threading.Condition()
        self._history, self._pending = History(wish), False
        self._stopped = False
        self._background: list[threading.Thread] = []
        self.good = compute(wish)
        self._thread = threading.Thread(target=self._work, name="rangelab-view", daemon=True)
        self._thread.start()

    @property
    def wish(self) -> Wish:
        """What was asked for last."""
        with self._changed:
            return self._history.present

    @property
    def document(self) -> Document | None:
        """The document, where it is none of a recording."""
        source = self.wish.source
        return None if isinstance(source, Recording) else source

    @property
    def before(self) -> Wish | None:
        """What was asked for before the last edit, of a drag before its beginning."""
        with self._changed:
            return self._history.before

    @property
    def stopped(self) -> bool:
        """Whether the viewer has ended, and with it what goes on in the background."""
        return self._stopped

    def still_asks(self, wish: Wish) -> bool:
        """Whether the document and the lab are still those of a wish: what is found for others is of no use."""
        with self._changed:
            present = self._history.present
            return not self._stopped and present.source is wish.source and present.lab == wish.lab

    def in_background(self, name: str, do: Callable[[], None]) -> None:
        """Does something long in a thread of its own, which asks `still_asks` often; `stop` waits for its end."""
        thread = threading.Thread(target=do, name=name, daemon=True)
        with self._changed:
            self._background = [*filter(threading.Thread.is_alive, self._background), thread]
            thread.start()

    def edit(self, change: Change, gesture: str = "") -> None:
        """Changes the document; a change that its rules forbid is refused and changes nothing."""
        try:
            with self._changed:
                wish = self._history.present
                if not isinstance(wish.source, Recording):
                    self._history.edit(wish.edited(change), gesture)
                    self._compute_soon()
        except Error as error:
            self._refuse(str(error))

    def ask(self, **changes: object) -> None:
        """Changes another part of the wish."""
        with self._changed:
            self._history.edit(replace(self._history.present, **changes))  # type: ignore[arg-type]
            self._compute_soon()

    def add(self, wish: Wish, **found: object) -> None:
        """Adds what was found for a wish, which is no edit; nothing where another one is shown."""
        with self._changed:
            if self.still_asks(wish):
                self._history.amend(replace(self._history.present, **found))  # type: ignore[arg-type]
                self._compute_soon()

    def undo(self) -> bool:
        """Takes the last edit back; False where there is none."""
        return self._go(History.undo)

    def redo(self) -> bool:
        """Makes it again; False where there is none."""
        return self._go(History.redo)

    def stop(self) -> None:
        """Ends the threads."""
        with self._changed:
            self._stopped = True
            self._changed.notify()
            threads = [self._thread, *self._background]
        for thread in threads:
            thread.join()

    def _go(self, way: Callable[[History[Wish]], bool]) -> bool:
        with self._changed:
            went = way(self._history)
            if went:
                self._compute_soon()
            return went

    def _compute_soon(self) -> None:
        self._pending = True
        self._changed.notify()

    def _work(self) -> None:
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._pending or self._stopped)
                if self._stopped:
                    return
                wish, self._pending = self._history.present, False
            try:
                self.good = self._compute(wish)
            except Error as error:
                with self._changed:
                    if self._history.present is wish:
                        self._history.amend(self.good.wish)
                self._refuse(str(error))
            else:
                self._show(self.good)
