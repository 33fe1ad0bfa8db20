"""The viewer: a scene, a timeline, controls and plots on one server."""

import threading
from pathlib import Path

import numpy as np
import viser

from ..families import preset_summary
from ..recording import Recording
from . import shapes
from .canvas import Canvas
from .file_panel import FilePanel
from .gizmos import Gizmos
from .labs import LABS, computed, lab_of, shows_field
from .labs.probe import read_at
from .panel import Panel
from .picture import Picture, Source, Wish
from .plots import Plots
from .port import PortTakenError, free_port
from .readout import Readout
from .save import recorded
from .stage import Stage
from .state import Studio
from .themes import THEMES
from .timeline import Timeline

PANEL_WIDTH = 400
ELLIPSOIDS = "Ellipsoids hold 95 % and are drawn as many times as large as errors."


class Viewer:
    """Serves a document until `stop`; `port` 0 takes any free one, `lab` is one of `rangelab.view.labs.LABS`.

    Raises:
        PortTakenError: where another program listens at the port, with advice.
        Error: where the document cannot be computed, in a sentence.
    """

    def __init__(
        self,
        source: Source,
        *,
        lab: str | None = None,
        theme: str = "light",
        host: str = "127.0.0.1",
        port: int = 8080,
        page: str = "",
    ) -> None:
        lab = lab_of(source, lab)
        wish = Wish(source, lab, field=shows_field(lab))
        asked = free_port(host, port)
        self._server = viser.ViserServer(host=host, port=asked, label="rangelab", verbose=False)
        if self._server.get_port() != asked:
            self._server.stop()
            raise PortTakenError(f"port {asked} was taken by another program just now; try again or choose another")
        self._host, self._drawing = host, threading.RLock()
        self._theme = THEMES[theme]
        self._studio = Studio(wish, computed, self._show, self._refuse)
        self._canvas = Canvas(self._server, self._theme, lambda place: read_at(self._studio, place))
        self._gizmos = Gizmos(self._server, self._theme, self._studio.edit)
        self._stage = Stage(self._server)
        self._lay_out(theme, page)
        self._show(self.shown)

    @property
    def address(self) -> str:
        """Where it is served."""
        return f"http://{'localhost' if self._host in ('127.0.0.1', '0.0.0.0') else self._host}:{self.port}"

    @property
    def port(self) -> int:
        """The port that is really used."""
        return self._server.get_port()

    @property
    def shown(self) -> Picture:
        """What is shown: the last that could be computed."""
        return self._studio.good

    @property
    def said(self) -> str:
        """What is told of it in words."""
        return str(self._note.content)

    @property
    def server(self) -> viser.ViserServer:
        """The server, to which programs may add what they like."""
        return self._server

    def open(self, source: Source, lab: str | None = None) -> None:
        """Shows another document."""
        lab = lab_of(source, lab)
        self._studio.ask(source=source, lab=lab, field=shows_field(lab), trial=0, study=None, probe=None)

    def look(self, theme: str) -> None:
        """Shows it in another theme: light, dark or projector."""
        with self._drawing:
            self._theme = self._canvas.theme = THEMES[theme]
            self._gizmos.recolour(self._theme)
            self._canvas.clear()
            self._stage.dress(self._theme)
            self._stage.frame(self.shown.outline, self._theme, camera=False)
            self._plots.draw(self.shown.plots(), self._theme)
            self.draw()

    def draw(self) -> None:
        """Draws the scene at the step of the timeline."""
        with self._drawing:
            self._draw(self._timeline.step)
            step = min(self._timeline.step, len(self.shown.times) - 1)
            self._readout.show(self.shown.readout(step), self._theme)

    def save(self, path: str | Path) -> None:
        """Writes the run as a player: one HTML file, or a `.viser` recording.

        Raises:
            ValueError: for another ending.
        """
        path = Path(path)
        if path.suffix not in (".html", ".viser"):
            raise ValueError(f"{path.name}: the file ends in .html or .viser")
        path.write_bytes(self.recorded(path.suffix))

    def recorded(self, ending: str) -> bytes:
        """What `save` writes into a file of this ending."""
        steps = len(self.shown.times)
        try:
            return recorded(self._server, self._draw, steps, ending)
        finally:
            self.draw()

    def wait(self) -> None:
        """Serves on."""
        self._server.sleep_forever()

    def stop(self) -> None:
        """Ends the server and its threads."""
        self._timeline.stop()
        self._studio.stop()
        self._server.stop()

    def _lay_out(self, theme: str, page: str) -> None:
        """The panels: what is told and controls on the right, plots below them."""
        gui = self._server.gui
        self._stage.dress(self._theme)
        gui.set_panel_label("rangelab")
        self._note = gui.add_markdown("")
        self._timeline = Timeline(self._server, len(self.shown.times), self.draw)
        self._tabs: viser.GuiTabGroupHandle | None = None
        self._panel: Panel | None = None
        self._controls = gui.add_folder("Controls")
        self._file = FilePanel(self._server, self, self._studio, theme, page)
        plots = gui.add_panel()
        told = plots.add_tab("Errors")
        with told:
            self._readout = Readout(self._server)
        self._plots = Plots(self._server, told)
        gui.main_panel.dock_right()
        plots.dock_below(gui.main_panel)
        gui.main_panel.set_width(PANEL_WIDTH)
        self._lab, self._framed = "", ("", "")

    def _show(self, picture: Picture) -> None:
        with self._drawing:
            if picture.wish.lab != self._lab:
                self._change_lab(picture.wish.lab)
            if (picture.wish.lab, picture.name) != self._framed:
                self._frame(picture)
            self._timeline.resize(len(picture.times))
            self.draw()
            self._plots.draw(picture.plots(), self._theme)
            self._file.follow(picture.wish)
            if self._panel is not None and not isinstance(picture.wish.source, Recording):
                self._panel.follow(picture.wish.source)
            self._say(picture)

    def _frame(self, picture: Picture) -> None:
        """Another scene: the view on all of it, at its end."""
        self._framed = (picture.wish.lab, picture.name)
        self._gizmos.clear()
        self._stage.frame(picture.outline, self._theme)
        self._timeline.magnify_by(picture.magnification)
        self._timeline.resize(len(picture.times))
        self._timeline.show(len(picture.times) - 1)

    def _change_lab(self, name: str) -> None:
        """Other controls."""
        self._lab = name
        if self._tabs is not None:
            self._tabs.remove()
        panel = Panel(self._server, self._studio)
        with self._controls:
            self._tabs = self._server.gui.add_tab_group()
        for title, controls in LABS[self._lab].tabs:
            with self._tabs.add_tab(title):
                controls(panel)
        self._panel = panel

    def _draw(self, step: int) -> None:
        with self._drawing:
            picture = self.shown
            extent = float(np.ptp(shapes.known(picture.outline), axis=0).max()) or 1.0
            self._canvas.unit = extent
            self._gizmos.show(picture.handles(), extent)
            with self._canvas.drawing():
                picture.draw(self._canvas, min(step, len(picture.times) - 1), self._timeline.magnification)

    def _say(self, picture: Picture) -> None:
        source = picture.wish.source
        teaching = "" if isinstance(source, Recording) else preset_summary(source)
        told = [f"**{picture.name}** {teaching}".strip(), *picture.sentences()]
        told += [ELLIPSOIDS] * self._canvas.ellipsoids
        self._note.content = "\n\n".join(told)

    def _refuse(self, sentence: str) -> None:
        self._note.content = f"**Not possible:** {sentence}"
        document = self._studio.document
        if document is not None and self._panel is not None:
            self._panel.follow(document)
        # A handle that was dragged to where nothing can be goes back.
        self.draw()
