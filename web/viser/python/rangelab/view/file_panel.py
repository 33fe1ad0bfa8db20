"""What is done with a document as a whole: another preset or lab, undo, theme, link of the page, files."""

from typing import TYPE_CHECKING, Any

import viser

from .._core import Error
from ..families import preset_named, preset_names
from ..link import from_link, to_link
from ..recording import Recording
from .labs import LABS, shows_field
from .picture import Source, Wish
from .state import Studio
from .themes import THEMES
from .values import by_hand, in_order, put

if TYPE_CHECKING:
    from .viewer import Viewer

OWN = "…"
"""Shown where a document is no preset."""


class FilePanel:
    """The controls that every document has."""

    def __init__(self, server: viser.ViserServer, viewer: "Viewer", studio: Studio, theme: str, page: str) -> None:
        self._gui, self._server, self._viewer, self._studio, self._page = server.gui, server, viewer, studio, page
        with self._gui.add_folder("Document"):
            self._document(theme)
        with self._gui.add_folder("Link of the page", expand_by_default=False) as self._link_folder:
            self._link = self._gui.add_text("link", "", hint="The whole scenario; paste another one to open it.")
            self._problem = self._gui.add_markdown("", visible=False)
            by_hand(self._link, self._pasted)
        with self._gui.add_folder("Save", expand_by_default=False):
            self._save_buttons()

    def follow(self, wish: Wish) -> None:
        """Shows what is open."""
        source = wish.source
        recorded = isinstance(source, Recording)
        name = None if isinstance(source, Recording) else source.to_dict()["name"]
        put(self._preset, name if name in self._preset.options else OWN)
        self._labs.visible = len(_labs_for(source)) > 1
        self._labs.options = tuple(_labs_for(source).values())
        put(self._labs, LABS[wish.lab].title)
        put(self._trial, wish.trial)
        self._trial.visible = not recorded
        self._link_folder.visible = not recorded
        if not isinstance(source, Recording):
            put(self._link, to_link(source, self._page))
            self._problem.visible = False

    def _document(self, theme: str) -> None:
        self._preset = self._gui.add_dropdown("preset", (OWN, *preset_names()))
        by_hand(self._preset, lambda name: None if name == OWN else self._viewer.open(preset_named(name)))
        self._labs = self._gui.add_dropdown("shown as", tuple(lab.title for lab in LABS.values()))
        by_hand(self._labs, self._shown_as)
        self._trial = self._gui.add_number("trial", 0, min=0, step=1, hint="other random numbers of the same seed")
        by_hand(self._trial, lambda value: self._studio.ask(trial=int(value)))
        themes = self._gui.add_dropdown("theme", tuple(THEMES), initial_value=theme)
        by_hand(themes, self._viewer.look)
        history = self._gui.add_button_group("edits", ("undo", "redo"))

        @history.on_click
        async def _(event: viser.GuiEvent[viser.GuiButtonGroupHandle]) -> None:
            in_order(self._undo if event.target.value == "undo" else self._redo)

    def _undo(self) -> None:
        self._studio.undo()

    def _redo(self) -> None:
        self._studio.redo()

    def _shown_as(self, title: str) -> None:
        name = next(name for name, lab in LABS.items() if lab.title == title)
        self._studio.ask(lab=name, field=shows_field(name), study=None)

    def _pasted(self, text: str) -> None:
        try:
            self._viewer.open(from_link(text.strip()))
        except Error as error:
            self._problem.content, self._problem.visible = f"**{error}**", True

    def _save_buttons(self) -> None:
        for label, ending in (
            ("one HTML file", ".html"),
            (".viser recording", ".viser"),
            ("the document, JSON", ".json"),
        ):
            button = self._gui.add_button(label)

            @button.on_click
            def _(event: viser.GuiEvent[Any], ending: str = ending) -> None:
                name = f"{self._viewer.shown.name or 'rangelab'}{ending}"
                source = self._viewer.shown.wish.source
                content = source.to_json().encode() if ending == ".json" else self._viewer.recorded(ending)
                (event.client or self._server).send_file_download(name, content)


def _labs_for(source: Source) -> dict[str, str]:
    return {name: lab.title for name, lab in LABS.items() if isinstance(source, lab.of)}
