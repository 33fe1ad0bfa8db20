"""The controls of the page's lab Explore: the bound as a landscape, where anchors should stand, what blocks ranges."""

from typing import Any

import numpy as np

from ..panel import Panel
from ..picture import Change
from .anchors import anchor_controls
from .choices import Chosen
from .field_panel import field_controls
from .obstacles import obstacle_controls
from .placement import placement_controls


def explore_controls(panel: Panel) -> None:
    """All that the bound depends on, besides the ranges' noise."""
    with panel.folder("Bound over a plane", opened=True):
        field_controls(panel)
    with panel.folder("Placement", opened=True):
        placement_controls(panel)
    with panel.folder("Walls and boxes", opened=True):
        obstacle_controls(panel)
    with panel.folder("Anchors"):
        anchor_controls(panel)
    with panel.folder("Sensors on the body"):
        _sensors(panel)


def _sensors(panel: Panel) -> None:
    """Where each sits, in the frame of the body."""
    chosen = Chosen(panel, "sensor", lambda document: [f"S{n + 1}" for n in range(len(document["sensors"]))])
    chosen.vector("sensors[#]", "position, m", step=0.05)
    chosen.act("Remove the sensor", _without_sensor)
    panel.button("Add a sensor", lambda: panel.edit("sensor", _with_sensor))
    panel.number("mounting_sigma", "mounting error σ_e, m", step=0.01, least=0.0)


def _with_sensor(scenario: Any) -> Any:
    sensors = np.array(scenario.to_dict()["sensors"])
    # Twice as far out as the first: never where another one sits.
    return scenario.replace(sensors=[*sensors.tolist(), (2 * sensors[0] + 0.1).tolist()])


def _without_sensor(index: int) -> Change:
    def change(scenario: Any) -> Any:
        sensors = scenario.to_dict()["sensors"]
        return scenario.replace(sensors=[each for n, each in enumerate(sensors) if n != index])

    return change
