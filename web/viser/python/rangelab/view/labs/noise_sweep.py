"""Localizers over a sweep of the noise: roughly at once, finely in the background."""

import threading
from typing import Any

import numpy as np

from ..._core import Cancelled, Error
from ...arrays import Floats
from ...scenario import Scenario
from ...studies import Study
from ..panel import Document, Panel
from ..picture import Wish
from ..progress import ProgressLine
from ..readout import reading
from .noise import median_range, same_noise_as

LAST = 100.0
"""Signal to noise ratios are from 0 to this, dB."""
COARSE_STEP, COARSE_TRIALS = 10.0, 20
FINE_STEP, FINE_TRIALS = 5.0, 1000


def zetas_by(step: float) -> Floats:
    """Signal to noise ratios, dB."""
    return np.arange(0.0, LAST + step / 2, step)


def noise_below(kind: str, distance: float, zeta: float) -> dict[str, Any]:
    """The noise of a model that lies so many decibels below a range (m)."""
    if kind == "toa":
        return {"kind": kind, "zeta_db": float(zeta)}
    deviation = distance * 10 ** (-zeta / 20)
    return {"kind": kind, "sigma": float(deviation * (2 if kind == "squared_range" else 1))}


def level_of(noise: dict[str, Any], distance: float) -> float:
    """How far a noise lies below a range (m), dB."""
    if noise["kind"] == "toa":
        return float(noise["zeta_db"])
    deviation = noise["sigma"] / (2 if noise["kind"] == "squared_range" else 1)
    return float(20 * np.log10(distance / deviation)) if deviation > 0 else float("inf")


def noises_of(document: Document, zetas: Floats) -> list[dict[str, Any]]:
    """The sweep: of the scenario's own model of the noise."""
    distance = median_range(document)
    return [noise_below(document["noise"]["kind"], distance, float(zeta)) for zeta in zetas]


def coarse_sweep(scenario: Scenario) -> Study:
    """Enough to see while one drags."""
    return scenario.localization_study(noises_of(scenario.to_dict(), zetas_by(COARSE_STEP)), COARSE_TRIALS)


class Sweeping:
    """The fine sweep of what is shown, one at a time; it begins anew where the scene changes."""

    def __init__(self, panel: Panel) -> None:
        self._studio = panel.studio
        self._line = ProgressLine(panel.gui)
        self._trials = panel.gui.add_number("trials a point", FINE_TRIALS, min=20, max=100_000, step=100)
        self._button = panel.button("Stop", self._press)
        self._running: tuple[Wish, threading.Event] | None = None
        panel.on_follow(lambda _: self._follow())

    def _follow(self) -> None:
        """Begins the sweep of another scene."""
        wish = self._studio.wish
        begun = self._running is not None and self._studio.still_asks(self._running[0])
        if wish.study is None and not begun:
            self._start(wish)

    def _press(self) -> None:
        wish = self._studio.wish
        if self._running is not None:
            self._running[1].set()
        else:
            self._start(wish)

    def _start(self, wish: Wish) -> None:
        called_off, trials = threading.Event(), int(self._trials.value)
        self._running = wish, called_off
        self._button.label = "Stop"
        self._studio.in_background("rangelab-sweep", lambda: self._sweep(wish, trials, called_off))

    def _sweep(self, wish: Wish, trials: int, called_off: threading.Event) -> None:
        assert isinstance(wish.source, Scenario)

        def told(done: int, of: int) -> bool:
            wanted = self._studio.still_asks(wish) and not called_off.is_set()
            if wanted:
                self._line.tell(done / of, f"Sweeping: {done} of {of}")
            return wanted

        noises = noises_of(wish.source.to_dict(), zetas_by(FINE_STEP))
        try:
            study = wish.source.localization_study(noises, trials, progress=told)
        except (Cancelled, Error) as error:
            self._end(wish, f"{error}".capitalize() + ".")
        else:
            self._studio.add(wish, study=study)
            self._end(wish, f"{study.trials} trials a point, every {FINE_STEP:g} dB; bands: two standard errors.")

    def _end(self, wish: Wish, sentence: str) -> None:
        """Nothing is said where another sweep has begun, or the panel has gone."""
        if self._studio.still_asks(wish) and self._running is not None and self._running[0] is wish:
            self._running = None
            self._button.label = "Sweep again"
            self._line.tell(None, sentence)


def sweep_controls(panel: Panel) -> None:
    """The fine sweep, and what its axis means in metres."""
    Sweeping(panel)
    panel.note(axis_told)


def axis_told(document: Document) -> str:
    """What decibels are in metres here."""
    distance, noise = median_range(document), document["noise"]
    own = reading(level_of(noise, distance))
    error = reading(same_noise_as(noise, "range", distance)["sigma"])
    ends = [reading(noise_below("range", distance, zeta)["sigma"]) for zeta in (0.0, LAST)]
    return (
        f"ζ: how far the noise lies below a range of {reading(distance)} m, the median here. {LAST:g} dB are a range "
        f"error of {ends[1]} m, 0 dB of {ends[0]} m. This scene: {own} dB, {error} m."
    )
