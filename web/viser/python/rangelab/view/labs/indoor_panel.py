"""The controls of the page's lab Indoor: what a lecture changes most comes first, with what choices mean."""

from typing import Any

import numpy as np

from ...indoor import IndoorScenario, indoor_presets
from ..looks import FILTERS
from ..panel import DEGREES, Document, Panel
from ..picture import Change
from . import indoor_cautions as cautions
from .averaging import averaging_controls
from .choices import Chosen
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
TELLING = ("ekf", "ekf-retraction", "ekf-rie", "mekf")
"""Enough filters to tell where the gain comes from: with these the page opens its presets."""
NO_LESSON = ""
STANDARD_GRAVITY = 9.80665


def indoor_controls(panel: Panel) -> None:
    """All that filters depend on."""
    with panel.folder("Lesson and path", opened=True):
        _lesson(panel)
    with panel.folder("Filters", opened=True):
        panel.several("filters.enabled", [(name, look.label) for name, look in FILTERS.items()])
        panel.button("The four of the lessons", lambda: panel.put("filters.enabled", TELLING), hint=_labels(TELLING))
        panel.button("All filters", lambda: panel.put("filters.enabled", tuple(FILTERS)))
        fan_control(panel)
    with panel.folder("Averages over trials", opened=True):
        averaging_controls(panel)
    with panel.folder("IMU", opened=True):
        _imu(panel)
    with panel.folder("Ranges", opened=True):
        _ranges(panel)
    with panel.folder("Retraction and transport"):
        _filter_settings(panel)
    with panel.folder("Positions of the transmitters"):
        _front_end(panel)
    with panel.folder("Start and P₀"):
        _start(panel)
    with panel.folder("Bias and place of the IMU"):
        _imu_faults(panel)
    with panel.folder("Beacons"):
        _beacons(panel)
    with panel.folder("Transmitters on the body"):
        _transmitters(panel)


def lesson(name: str) -> Change:
    """A preset with the filters that tell its lesson; the others are switched on by hand."""
    return lambda _: IndoorScenario.preset(name).replace({"filters.enabled": TELLING})


def _labels(names: tuple[str, ...]) -> str:
    return "; ".join(FILTERS[name].label for name in names)


def _lesson(panel: Panel) -> None:
    titles = {each["name"]: each["title"] for each in indoor_presets()}
    options = ((NO_LESSON, "…"), *titles.items())

    def teach(name: str) -> None:
        if name != NO_LESSON:
            panel.edit("lesson", lesson(name))

    panel.chooser("lesson", options, lambda found: found["name"] if found["name"] in titles else NO_LESSON, teach)
    panel.chooser("path", PATHS, lambda found: str(found["path"]), lambda kind: panel.edit("path", _walking(kind)))
    seed_controls(panel)


def _ranges(panel: Panel) -> None:
    panel.number("ranging.sigma", "range σ, m", step=0.01, least=0.0)
    panel.note(cautions.on_ranges)
    panel.number("ranging.interval", "between fixes, s", step=0.1, least=0.0)
    panel.number("ranging.missing_probability", "missing ranges, %", factor=100.0, step=5.0, least=0.0, most=100.0)


def _imu(panel: Panel) -> None:
    panel.number("imu.rate_hz", "rate, Hz", step=1.0, least=0.0)
    panel.choice("imu.convention", "samples are", [(name, name) for name in cautions.CONVENTION])
    panel.note(cautions.on_convention)
    panel.number("imu.gyroscope_density_degrees", "gyroscope, °/s/√Hz", step=0.01, least=0.0)
    panel.number("imu.accelerometer_density_micro_g", "accelerometer, µg/√Hz", step=10.0, least=0.0)
    panel.tick(
        "gravity is felt",
        lambda found: bool(found["imu"]["gravity"]),
        lambda felt: panel.put("imu.gravity", STANDARD_GRAVITY if felt else 0.0),
    )
    panel.number("imu.gravity", "gravity, m/s²", step=0.1)
    panel.note(cautions.on_gravity)


def _imu_faults(panel: Panel) -> None:
    panel.vector("imu.gyroscope_bias", "gyroscope bias, deg/s", factor=DEGREES, step=0.01)
    panel.vector("imu.accelerometer_bias", "accelerometer bias, m/s²", step=0.001)
    panel.note(lambda _: cautions.BIAS)
    panel.vector("imu.lever_arm", "place on the body, m", step=0.05)
    corrections = {"corrected": "corrected", "ignored": "ignored", "printed": "as printed"}
    panel.chooser(
        "its effect is",
        tuple(corrections.items()),
        lambda found: str(found["imu"]["lever_arm_correction"]) if any(found["imu"]["lever_arm"]) else None,
        lambda kind: panel.put("imu.lever_arm_correction", kind),
    )
    panel.note(cautions.on_lever_arm)


def _filter_settings(panel: Panel) -> None:
    of = "filters."
    panel.choice(of + "retraction", "retraction", (("qr", "QR"), ("polar", "polar"), ("exponential", "Exp")))
    panel.note(cautions.on_retraction)
    transports = (
        ("none", "none"),
        ("literal", "literal, as printed"),
        ("block", "block of R"),
        ("congruence", "all of P"),
    )
    panel.choice(of + "transport", "transport", transports)
    panel.note(cautions.on_transport)
    panel.switch(of + "tangent_correction", "project corrections of R on the tangent space")
    panel.choice(of + "input_noise_weights", "weights of the UKF", (("once", "once"), ("squared", "squared")))


def _front_end(panel: Panel) -> None:
    of = "filters."
    kinds = (("gauss-newton", "Gauss-Newton, each alone"), ("isosceles", "the triangle, all at once"))
    panel.choice(of + "front_end", "from ranges by", kinds)
    panel.choice(of + "fix_covariance", "covariance", (("isotropic", "σ² I"), ("geometry", "σ² (JᵀJ)⁻¹")))
    panel.note(cautions.on_fixes)
    panel.choice(of + "transmitters", "transmitters", (("all", "all three"), ("first", "the first alone")))


def _start(panel: Panel) -> None:
    kinds = (("isotropic", "full, c I"), ("tangent", "tangent"))
    panel.chooser(
        "P₀ is",
        kinds,
        lambda found: str(found["start"]["prior"]["kind"]),
        lambda kind: panel.put("start.prior", PRIORS[kind]),
    )
    panel.number("start.prior.variance", "variance c", step=1e-6, least=0.0)
    panel.number("start.prior.angle", "angle σ, deg", factor=DEGREES, step=0.5, least=0.0)
    panel.number("start.prior.position", "position σ, m", step=0.01, least=0.0)
    panel.number("start.prior.velocity", "velocity σ, m/s", step=0.01, least=0.0)
    panel.note(cautions.on_prior)
    panel.switch("start.drawn", "draw the first guess from P₀")


def _beacons(panel: Panel) -> None:
    chosen = Chosen(panel, "beacon", lambda document: [f"B{m + 1}" for m in range(len(document["beacons"]))])
    chosen.vector("beacons[#]", "position, m", step=0.1)
    chosen.act("Remove the beacon", _without)
    panel.button("Add a beacon", lambda: panel.edit("beacon", _with_one_more))
    panel.button(
        "Put them around the path",
        lambda: panel.edit("around", lambda scenario: scenario.replace(beacons=[])),
        hint="four alternate corners of the box around it, 2 m away",
    )
    panel.note(lambda _: cautions.BEACONS)


def _transmitters(panel: Panel) -> None:
    chosen = Chosen(panel, "transmitter", lambda found: [f"{n + 1}" for n in range(len(found["transmitters"]))])
    chosen.vector("transmitters[#]", "position on the body, m", step=0.01)
    panel.note(lambda _: cautions.TRANSMITTERS)


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
