"""An IMU and three transmitters on a body among beacons: filters side by side."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...arrays import Floats
from ...indoor import IndoorFilterRun, IndoorRun, IndoorScenario
from ..canvas import Canvas
from ..looks import FILTERS
from ..panel import DEGREES, Document, Panel
from ..picture import Change, Handle, Wish
from ..plots import Line, Plot, expected
from ..readout import Row, Table
from . import drawing
from .averages import Averaged
from .averaging import averaging_controls
from .choices import Chosen
from .indoor_averages import averaged_plots, averaged_readout
from .track_panel import fan_control, seed_controls

PATHS = (
    ("u", "a turn back (U)"),
    ("zigzag", "a zigzag"),
    ("bridge", "over a bridge"),
    ("stair", "up a staircase"),
    ("static", "at rest"),
    ("tumble", "tumbling"),
)
PRIORS: dict[str, Document] = {
    "isotropic": {"kind": "isotropic", "variance": 1e-6},
    "tangent": {"kind": "tangent", "angle": float(np.radians(5.0)), "position": 0.1, "velocity": 0.1},
}


@dataclass
class IndoorPicture(Averaged):
    """A run of the filters."""

    wish: Wish
    run: IndoorRun

    @property
    def name(self) -> str:
        """What people call it."""
        return self.run.name

    @property
    def times(self) -> Floats:
        """Time at the end of each step, s: K."""
        return self.run.times

    @property
    def outline(self) -> Floats:
        """Beacons and the true track."""
        return np.concatenate([self.run.beacons, self.run.truth_positions])

    @property
    def magnification(self) -> float:
        """So that the largest error is seen and stays in the scene."""
        errors = [each.position_errors for each in self.run.filters.values()]
        return min(10.0, drawing.magnification(errors, drawing.extent_of(self.outline), 0.3))

    @property
    def body(self) -> Floats:
        """The transmitters as they are drawn, in the body frame, m: 3 x 3."""
        return self.run.transmitters * self._scale

    @property
    def _scale(self) -> float:
        return drawing.body_scale(self.run.transmitters, drawing.extent_of(self.outline))

    def sentences(self) -> list[str]:
        """Who stopped, and why."""
        stopped = [f"{each.label} stopped: {each.failure[1]}" for each in self.run.filters.values() if each.failure]
        return [*stopped, *drawing.scale_sentence(self._scale)]

    def handles(self) -> list[Handle]:
        """The beacons."""
        source = self.wish.source
        assert isinstance(source, IndoorScenario)
        return [_beacon(m, np.array(place)) for m, place in enumerate(source.to_dict()["beacons"])]

    def plots(self) -> list[Plot]:
        """The page's plots of one run, or of the averages that there are."""
        if self.averages is not None:
            return averaged_plots(self.averages, self.times)
        filters, degrees, lines = self.run.filters, float(np.degrees(1.0)), drawing.lines_of
        angles = {name: each.orientation_errors for name, each in filters.items()}
        positions = {name: each.position_errors for name, each in filters.items()}
        stretch = {name: each.singular_values[:, 0] for name, each in filters.items()}
        nees = {name: each.nees for name, each in filters.items()}
        return [
            self._plot("Position error, m", lines(FILTERS, positions)),
            self._plot("Orientation error, deg", lines(FILTERS, angles, degrees)),
            self._plot("Largest singular value of R", lines(FILTERS, stretch)),
            self._plot("NEES / dof", (*lines(FILTERS, nees), expected(self.times))),
        ]

    def readout(self, step: int) -> Table:
        """Errors at a step with the largest singular value of R, and root mean squares over the run with its NEES."""
        if self.averages is not None:
            return averaged_readout(self.averages, step, list(self.run.filters))
        rows = tuple(self._row(name, each, step) for name, each in self.run.filters.items())
        heads = ("orient.\ndeg", "position\nm")
        return Table((("at this step", (*heads, "‖R‖")), ("RMSE of the run", (*heads, "NEES\n÷ dof"))), rows)

    def draw(self, canvas: Canvas, step: int, magnify: float) -> None:
        """Track and body, estimates with their ellipsoids."""
        run, truth = self.run, self.run.truth_positions
        drawing.draw_truth(canvas, run.truth_orientations, truth, self.body, step)
        manner = drawing.Manner(truth, self.body, magnify, self.wish.fans)
        for (name, each), rim in zip(run.filters.items(), drawing.rims(len(run.filters)), strict=True):
            drawing.draw_estimate(canvas, FILTERS[name], each, step, rim, manner)

    def _row(self, name: str, each: IndoorFilterRun, step: int) -> Row:
        found = drawing.readings(each.orientation_errors, each.position_errors, step)
        nees = each.nees[np.isfinite(each.nees)]
        mean = float(nees.mean()) if len(nees) else float("nan")
        numbers = (*found[:2], float(each.singular_values[step, 0]), *found[2:], mean)
        return Row(FILTERS[name], numbers, drawing.ended(each, step))

    def _plot(self, title: str, lines: tuple[Line, ...]) -> Plot:
        return Plot(title, self.times, lines)


def indoor(wish: Wish) -> IndoorPicture:
    """Runs the crate.

    Raises:
        Error: in a sentence.
    """
    assert isinstance(wish.source, IndoorScenario)
    return IndoorPicture(wish, wish.source.run(wish.trial))


def indoor_controls(panel: Panel) -> None:
    """The controls of the page's lab Indoor."""
    with panel.folder("Path", opened=True):
        panel.chooser("path", PATHS, lambda document: document["path"], lambda kind: panel.edit("path", _walking(kind)))
        seed_controls(panel)
    with panel.folder("Filters", opened=True):
        panel.several("filters.enabled", [(name, look.label) for name, look in FILTERS.items()])
        fan_control(panel)
    with panel.folder("Averages over trials", opened=True):
        averaging_controls(panel)
    with panel.folder("Ranges", opened=True):
        panel.number("ranging.sigma", "range σ, m", step=0.01, least=0.0)
        panel.number("ranging.interval", "between fixes, s", step=0.1, least=0.0)
        panel.number("ranging.missing_probability", "missing ranges, %", factor=100.0, step=5.0, least=0.0, most=100.0)
    with panel.folder("IMU", opened=True):
        _imu(panel)
    with panel.folder("Retraction and transport"):
        _filter_settings(panel)
    with panel.folder("Positions of the transmitters"):
        _front_end(panel)
    with panel.folder("Start and P₀"):
        _start(panel)
    with panel.folder("Beacons"):
        _beacons(panel)


def _imu(panel: Panel) -> None:
    panel.choice("imu.convention", "samples are", [(name, name) for name in ("sample", "disc", "mean", "trap")])
    panel.number("imu.rate_hz", "rate, Hz", step=1.0, least=0.0)
    panel.number("imu.gyroscope_density_degrees", "gyroscope, °/s/√Hz", step=0.01, least=0.0)
    panel.number("imu.accelerometer_density_micro_g", "accelerometer, µg/√Hz", step=10.0, least=0.0)
    panel.number("imu.gravity", "gravity, m/s²", step=0.1)
    panel.vector("imu.gyroscope_bias", "gyroscope bias, deg/s", factor=DEGREES, step=0.01)
    panel.vector("imu.accelerometer_bias", "accelerometer bias, m/s²", step=0.001)
    panel.vector("imu.lever_arm", "lever arm, m", step=0.05)
    corrections = (("corrected", "corrected"), ("ignored", "ignored"), ("printed", "as printed"))
    panel.choice("imu.lever_arm_correction", "lever arm is", corrections)


def _filter_settings(panel: Panel) -> None:
    of = "filters."
    panel.choice(of + "retraction", "retraction", (("qr", "QR"), ("polar", "polar"), ("exponential", "Exp")))
    transports = (
        ("none", "none"),
        ("literal", "literal, as printed"),
        ("block", "block of R"),
        ("congruence", "all of P"),
    )
    panel.choice(of + "transport", "transport", transports)
    panel.switch(of + "tangent_correction", "project corrections of R on the tangent space")
    panel.choice(of + "input_noise_weights", "weights of the UKF", (("once", "once"), ("squared", "squared")))


def _front_end(panel: Panel) -> None:
    of = "filters."
    kinds = (("gauss-newton", "Gauss-Newton, each alone"), ("isosceles", "the triangle, all at once"))
    panel.choice(of + "front_end", "from ranges by", kinds)
    panel.choice(of + "fix_covariance", "covariance", (("isotropic", "σ² I"), ("geometry", "σ² (JᵀJ)⁻¹")))
    panel.choice(of + "transmitters", "transmitters", (("all", "all three"), ("first", "the first alone")))


def _start(panel: Panel) -> None:
    kinds = (("isotropic", "full, c I"), ("tangent", "tangent"))
    panel.chooser(
        "P₀ is",
        kinds,
        lambda found: found["start"]["prior"]["kind"],
        lambda kind: panel.put("start.prior", PRIORS[kind]),
    )
    panel.number("start.prior.variance", "variance P₀", step=1e-6, least=0.0)
    panel.number("start.prior.angle", "angle σ, deg", factor=DEGREES, step=0.5, least=0.0)
    panel.number("start.prior.position", "position σ, m", step=0.01, least=0.0)
    panel.number("start.prior.velocity", "velocity σ, m/s", step=0.01, least=0.0)
    panel.switch("start.drawn", "draw the first guess from P₀")


def _beacons(panel: Panel) -> None:
    chosen = Chosen(panel, "beacon", lambda document: [f"B{m + 1}" for m in range(len(document["beacons"]))])
    chosen.vector("beacons[#]", "position, m", step=0.1)
    chosen.act("Remove the beacon", _without)
    panel.button("Add a beacon", lambda: panel.edit("beacon", _with_one_more))
    panel.button(
        "Put them around the path", lambda: panel.edit("around", lambda scenario: scenario.replace(beacons=[]))
    )


def _walking(path: str) -> Change:
    """Another path has another box: its own beacons stand around it."""
    return lambda scenario: scenario.replace(path=path, beacons=[])


def _with_one_more(scenario: Any) -> Any:
    """One more beacon, in the middle of the others."""
    beacons = scenario.to_dict()["beacons"]
    return scenario.replace(beacons=[*beacons, [float(f"{value:.3g}") for value in np.mean(beacons, axis=0)]])


def _without(index: int) -> Change:
    def change(scenario: Any) -> Any:
        beacons = scenario.to_dict()["beacons"]
        return scenario.replace(beacons=[each for m, each in enumerate(beacons) if m != index])

    return change


def _beacon(m: int, place: Floats) -> Handle:
    return Handle(
        f"/anchors/{m}", f"B{m + 1}", place, lambda to, _: lambda scenario: scenario.replace({f"beacons[{m}]": to})
    )
