"""The viewer: a scene, a timeline, controls and plots on one server."""

import threading
from pathlib import Path
from typing import Any

import numpy as np
import viser

from ..arrays import Floats
from ..scenario import Scenario
from .controls import Controls
from .plots import plots
from .port import PortTakenError, free_port
from .save import recorded
from .scene import Scene
from .source import Source
from .state import Shown, Studio, Wish
from .timeline import Timeline


class Viewer:
    """Serves a scenario or recording until `stop`; `port` 0 takes any free one.

    Raises:
        PortTakenError: where another program listens at the port, with advice.
    """

    def __init__(self, source: Source, *, host: str = "127.0.0.1", port: int = 8080, page: str = "") -> None:
        asked = free_port(host, port)
        self._server = viser.ViserServer(host=host, port=asked, label="rangelab", verbose=False)
        if self._server.get_port() != asked:
            self._server.stop()
            raise PortTakenError(f"port {asked} was taken by another program just now; try again or choose another")
        self._host, self._drawing = host, threading.Lock()
        self._studio = Studio(Wish(source), self._show, self._refuse)
        self._note = self._server.gui.add_markdown("")
        self._timeline = Timeline(self._server, len(self.shown.run.times), self.draw)
        self._scene = Scene(self._server, self._moved, self._posed)
        self._plots = plots(self._server, self._server.gui.add_folder("Plots"))
        self._controls = Controls(self._server, self._studio, self.open, page)
        self._save_buttons()
        self._server.gui.configure_theme(control_width="large", show_share_button=False)
        self._scene.frame(self.shown)
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
    def shown(self) -> Shown:
        """What is shown: the last run that could be computed."""
        return self._studio.good

    @property
    def server(self) -> viser.ViserServer:
        """The server, to which programs may add what they like."""
        return self._server

    def open(self, source: Scenario) -> None:
        """Shows another scenario."""
        self._studio.ask(source=source)

    def draw(self) -> None:
        """Draws the scene at the step of the timeline."""
        with self._drawing:
            shown = self.shown
            step = min(self._timeline.step, len(shown.run.times) - 1)
            self._scene.draw(shown, step, float(self._timeline.magnify.value))

    def save(self, path: str | Path) -> None:
        """Writes the run as a player: one HTML file, or a `.viser` recording.

        Raises:
            ValueError: for another ending.
        """
        path = Path(path)
        if path.suffix not in (".html", ".viser"):
            raise ValueError(f"{path.name}: the file ends in .html or .viser")
        path.write_bytes(self._recorded(path.suffix))

    def wait(self) -> None:
        """Serves on."""
        self._server.sleep_forever()

    def stop(self) -> None:
        """Ends the server and its threads."""
        self._timeline.stop()
        self._studio.stop()
        self._server.stop()

    def _show(self, shown: Shown) -> None:
        self._timeline.resize(len(shown.run.times))
        self.draw()
        for plot in self._plots:
            plot.draw(shown.run)
        if isinstance(shown.wish.source, Scenario):
            self._controls.follow(shown.wish.source)
        self._say(shown)

    def _say(self, shown: Shown) -> None:
        run = shown.run
        stopped = [f"{each.label} stopped: {each.failure[1]}" for each in run.estimators.values() if each.failure]
        sentences = [run.unseen or "", *stopped, _range_of(shown)]
        self._note.content = "\n\n".join([f"**{run.name}**", *filter(None, sentences)])

    def _refuse(self, sentence: str) -> None:
        self._note.content = f"**Not possible:** {sentence}"
        if self._studio.scenario is not None:
            self._controls.follow(self._studio.scenario)

    def _moved(self, anchor: int, place: Floats) -> None:
        self._studio.edit(lambda scenario: scenario.replace({f"anchors[{anchor}]": place}))

    def _posed(self, orientation: Floats, position: Floats) -> None:
        start = {"start.orientation": orientation, "start.position": position}
        self._studio.edit(lambda scenario: scenario.replace(start))

    def _recorded(self, ending: str) -> bytes:
        steps = len(self.shown.run.times)
        before = self._timeline.step

        def show(step: int) -> None:
            with self._drawing:
                self._scene.draw(self.shown, step, float(self._timeline.magnify.value))

        try:
            return recorded(self._server, show, steps, ending)
        finally:
            show(min(before, steps - 1))

    def _save_buttons(self) -> None:
        with self._server.gui.add_folder("Save", expand_by_default=False):
            for label, ending in (("one HTML file", ".html"), (".viser recording", ".viser")):
                button = self._server.gui.add_button(label)

                @button.on_click
                def _(event: viser.GuiEvent[Any], ending: str = ending) -> None:
                    name = self.shown.run.name or "rangelab"
                    (event.client or self._server).send_file_download(f"{name}{ending}", self._recorded(ending))


def _range_of(shown: Shown) -> str:
    """What the colours of the field mean."""
    if shown.field is None or not np.isfinite(shown.field.values).any():
        return ""
    source = shown.wish.source
    assert isinstance(source, Scenario)
    of = source.to_dict()["field"]["quantity"]
    factor, unit = (1e3, "mm") if of == "position" else (float(np.degrees(1.0)), "deg")
    low, high = factor * np.nanmin(shown.field.values), factor * np.nanmax(shown.field.values)
    return f"Bound of the {of}: {low:.3g} {unit} (dark) to {high:.3g} {unit} (bright)."
