"""Controls that are bound to values of the document: each shows its value, writes it, and hides where there is none."""

import time
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
import viser

from ..documents import Written, found
from .picture import Change
from .state import Studio
from .values import at_a_press, by_hand, put

PAUSE = 1.0
"""Edits of one value with no longer pauses between them are one entry of the history, s."""
DEGREES = float(np.degrees(1.0))
DIGITS = 9
Document = dict[str, Any]


class Panel:
    """The controls of one lab in the container that is open; `follow` puts them where the document is."""

    def __init__(self, server: viser.ViserServer, studio: Studio) -> None:
        self.server, self.gui, self.studio = server, server.gui, studio
        self._follow: list[Callable[[Document], None]] = []
        self._last: tuple[str, float, int] = ("", 0.0, 0)

    def follow(self, document: Written) -> None:
        """Shows the values of a document, which are no edits."""
        self.show(document.to_dict())

    def show(self, values: Document) -> None:
        """Shows the values of a document that is a dictionary already."""
        for write in self._follow:
            write(values)

    def on_follow(self, write: Callable[[Document], None]) -> None:
        """Something else that follows the document."""
        self._follow.append(write)

    def folder(self, title: str, *, opened: bool = False) -> viser.GuiFolderHandle:
        """A group of controls."""
        return self.gui.add_folder(title, expand_by_default=opened)

    def at(self, path: str) -> str:
        """A path as the document has it."""
        return path

    def edit(self, what: str, change: Change) -> None:
        """An edit; those of the same thing shortly after each other are one gesture."""
        last, moment, number = self._last
        now = time.monotonic()
        number += last != what or now - moment > PAUSE
        self._last = (what, now, number)
        self.studio.edit(change, f"{what} {number}")

    def put(self, path: str, value: Any) -> None:
        """An edit of one value."""
        at = self.at(path)
        self.edit(at, lambda document: document.replace({at: value}))

    def value(self, document: Document, path: str, missing: Any = None) -> Any:
        """The value at a path."""
        return found(document, self.at(path), missing)

    def number(
        self,
        path: str,
        label: str,
        *,
        step: float = 0.01,
        least: float | None = None,
        most: float | None = None,
        factor: float = 1.0,
        hint: str | None = None,
    ) -> None:
        """A number, shown `factor` times as large; a whole one has whole steps."""
        whole = isinstance(step, int)
        first = least if least is not None else 0
        # viser makes all later values of the type of the first.
        handle = self.gui.add_number(label, first if whole else float(first), min=least, max=most, step=step, hint=hint)
        handle.precision = 0 if whole else DIGITS

        def write(document: Document) -> None:
            value = self.value(document, path)
            handle.visible = value is not None
            if value is not None:
                put(handle, value if whole else _shown(factor * value))

        by_hand(handle, lambda value: self.put(path, int(value) if whole else float(value) / factor))
        self.on_follow(write)

    def vector(self, path: str, label: str, *, step: float = 0.01, factor: float = 1.0) -> None:
        """Two or three numbers, one in the plane where it is a turn."""
        axes = {1: self.gui.add_number(f"{label}, about z", 0.0, step=step, visible=False)}
        axes[1].precision = DIGITS
        boxes: dict[int, Any] = {
            **axes,
            2: self.gui.add_vector2(label, (0.0, 0.0), step=step, visible=False),
            3: self.gui.add_vector3(label, (0.0, 0.0, 0.0), step=step, visible=False),
        }

        def write(document: Document) -> None:
            values = self.value(document, path)
            for count, box in boxes.items():
                box.visible = values is not None and len(values) == count
                if values is not None and box.visible:
                    shown = tuple(_shown(factor * value) for value in values)
                    put(box, shown[0] if count == 1 else shown)

        for box in boxes.values():
            by_hand(box, lambda value: self.put(path, [each / factor for each in np.atleast_1d(value).tolist()]))
        self.on_follow(write)

    def choice(self, path: str, label: str, options: Sequence[tuple[str, str]], *, hint: str | None = None) -> None:
        """One of several values, each with its words."""
        words = dict(options)
        self.chooser(
            label,
            options,
            lambda document: self.value(document, path) if self.value(document, path) in words else None,
            lambda value: self.put(path, value),
            hint=hint,
        )

    def chooser(
        self,
        label: str,
        options: Sequence[tuple[str, str]],
        read: Callable[[Document], str | None],
        write: Callable[[str], None],
        *,
        hint: str | None = None,
    ) -> None:
        """One of several things; hidden where the document has none of them."""
        words = dict(options)
        values = {word: value for value, word in options}
        handle = self.gui.add_dropdown(label, tuple(words.values()), hint=hint)

        def follow(document: Document) -> None:
            value = read(document)
            handle.visible = value is not None
            if value is not None:
                put(handle, words[value])

        by_hand(handle, lambda word: write(values[word]))
        self.on_follow(follow)

    def optional(
        self,
        label: str,
        read: Callable[[Document], float | str | None],
        write: Callable[[float | None], None],
        *,
        first: float,
        step: float = 0.1,
    ) -> None:
        """A number that may be left out: a box, and the number where it is ticked; hidden where `read` says so."""
        box = self.gui.add_checkbox(label, False)
        number = self.gui.add_number(f"… {label}", first, step=step)
        number.precision = DIGITS

        def follow(document: Document) -> None:
            value = read(document)
            box.visible = value != "hidden"
            number.visible = isinstance(value, float | int)
            put(box, number.visible)
            if number.visible:
                put(number, value)

        by_hand(box, lambda ticked: write(first if ticked else None))
        by_hand(number, lambda value: write(float(value)))
        self.on_follow(follow)

    def switch(self, path: str, label: str, *, hint: str | None = None) -> None:
        """Yes or no."""
        self.tick(
            label, lambda document: bool(self.value(document, path)), lambda value: self.put(path, value), hint=hint
        )

    def tick(
        self,
        label: str,
        read: Callable[[Document], bool | None],
        write: Callable[[bool], None],
        *,
        hint: str | None = None,
    ) -> None:
        """A box that is ticked or not; hidden where the document has neither."""
        handle = self.gui.add_checkbox(label, False, hint=hint)

        def follow(document: Document) -> None:
            value = read(document)
            handle.visible = value is not None
            put(handle, bool(value))

        by_hand(handle, write)
        self.on_follow(follow)

    def several(self, path: str, options: Sequence[tuple[str, str]]) -> None:
        """Any of several, each with a box."""
        boxes = {name: self.gui.add_checkbox(label, False) for name, label in options}

        def write(document: Document) -> None:
            enabled = self.value(document, path) or ()
            for name, box in boxes.items():
                put(box, name in enabled)

        def switch(name: str, ticked: bool) -> None:
            def change(document: Any) -> Any:
                enabled = {*found(document.to_dict(), path)} - {name} | ({name} if ticked else set())
                return document.replace({path: [each for each in boxes if each in enabled]})

            self.edit(path, change)

        for name, box in boxes.items():
            by_hand(box, partial(switch, name))
        self.on_follow(write)

    def note(self, read: Callable[[Document], str]) -> None:
        """A sentence about the document; none where it is empty."""
        handle = self.gui.add_markdown("", visible=False)

        def follow(document: Document) -> None:
            text = read(document)
            handle.visible = bool(text)
            if handle.content != text:
                handle.content = text

        self.on_follow(follow)

    def button(self, label: str, do: Callable[[], None], *, hint: str | None = None) -> viser.GuiButtonHandle:
        """Something that is done at a press."""
        handle = self.gui.add_button(label, hint=hint)
        at_a_press(handle, do)
        return handle


def _shown(value: float) -> float:
    """Without the noise of the last bits."""
    return float(f"{value:.9g}")
