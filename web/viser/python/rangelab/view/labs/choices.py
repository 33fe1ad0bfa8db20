"""Controls of one of many, chosen by its name: the panel is no longer for a hundred anchors than for one."""

from collections.abc import Callable
from typing import cast

import viser

from ..panel import Document, Panel
from ..picture import Change
from ..values import by_hand, put

HIDDEN = "hidden"


class Chosen(Panel):
    """A panel whose paths have `#` in place of the number of the one that is chosen."""

    def __init__(self, panel: Panel, what: str, names: Callable[[Document], list[str]]) -> None:
        super().__init__(panel.server, panel.studio)
        self.index = 0
        """Which one is chosen."""
        self._names = names
        self._list: viser.GuiDropdownHandle[str] = self.gui.add_dropdown(what, cast("tuple[str, ...]", ("–",)))
        by_hand(self._list, self._choose)
        panel.on_follow(self._write)

    def at(self, path: str) -> str:
        """A path of the one that is chosen."""
        return path.replace("#", str(self.index))

    def act(self, label: str, change: Callable[[int], Change]) -> None:
        """A button for the one that is chosen."""
        button = self.button(label, lambda: self.edit(label, change(self.index)))

        def follow(document: Document) -> None:
            button.visible = bool(self._names(document))

        self.on_follow(follow)

    def optional_value(self, path: str, label: str, *, first: float) -> None:
        """A number of the document that may be null."""
        self.optional(
            label,
            lambda document: self.value(document, path, HIDDEN),
            lambda value: self.put(path, value),
            first=first,
        )

    def _choose(self, name: str) -> None:
        self.index = self._list.options.index(name)
        document = self.studio.document
        if document is not None:
            self.follow(document)

    def _write(self, document: Document) -> None:
        names = self._names(document)
        self._list.visible = bool(names)
        self.index = min(self.index, max(len(names) - 1, 0))
        if names and tuple(names) != tuple(self._list.options):
            self._list.options = tuple(names)
        if names:
            put(self._list, names[self.index])
        self.show(document)
