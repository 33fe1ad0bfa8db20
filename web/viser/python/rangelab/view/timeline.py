"""The timeline: which step is shown, and playing."""

import threading
from collections.abc import Callable

import viser

from .values import put


class Timeline:
    """A slider over the steps of a run, with play and single steps."""

    def __init__(self, server: viser.ViserServer, steps: int, changed: Callable[[], None]) -> None:
        self._server, self._changed = server, changed
        self._playing, self._stopped = threading.Event(), threading.Event()
        with server.gui.add_folder("Time"):
            self._slider = server.gui.add_slider("step", 0, max(steps - 1, 1), 1, max(steps - 1, 0))
            self._buttons = server.gui.add_button_group("move", ("◀", "▶", "play", "pause"))
            self._magnify = server.gui.add_number("errors drawn, ×", 10.0, min=0.1, step=1.0)
            self._magnify.precision = 2
            self._playing_folder = server.gui.add_folder("Playing", expand_by_default=False)
            with self._playing_folder:
                self._speed = server.gui.add_number("steps a second", 10.0, min=0.5, max=60.0, step=0.5)
        self._slider.on_update(lambda _: changed())
        self._magnify.on_update(lambda _: changed())
        self._buttons.on_click(lambda event: self._press(event.target.value))
        self._thread = threading.Thread(target=self._play, name="rangelab-play", daemon=True)
        self._thread.start()

    @property
    def magnification(self) -> float:
        """How many times as large errors are drawn."""
        return float(self._magnify.value)

    def magnify_by(self, times: float) -> None:
        """Draws errors so many times as large."""
        put(self._magnify, times)

    @property
    def step(self) -> int:
        """The step that is shown."""
        return int(self._slider.value)

    def show(self, step: int) -> None:
        """Goes to a step."""
        put(self._slider, step)

    def resize(self, steps: int) -> None:
        """A run of another length."""
        last = max(steps - 1, 1)
        for control in (self._slider, self._buttons, self._playing_folder):
            control.visible = steps > 1
        if last != self._slider.max:
            put(self._slider, min(self.step, max(steps - 1, 0)))
            self._slider.max = last

    def stop(self) -> None:
        """Ends the thread."""
        self._stopped.set()
        self._playing.set()
        self._thread.join()

    def _press(self, button: str) -> None:
        if button in ("◀", "▶"):
            self._playing.clear()
            self._move(1 if button == "▶" else -1)
        elif button == "play":
            self._playing.set()
        else:
            self._playing.clear()

    def _move(self, by: int) -> None:
        put(self._slider, (self.step + by) % (int(self._slider.max) + 1))

    def _play(self) -> None:
        while not self._stopped.is_set():
            self._playing.wait()
            if not self._stopped.wait(1 / float(self._speed.value)) and self._playing.is_set():
                self._move(1)
