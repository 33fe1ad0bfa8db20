"""The controls of the page's lab Anchorless: what a lecture changes most comes first."""

import re
from collections.abc import Sequence
from typing import Any

import numpy as np

from ...kinematics import KinematicsScenario, kinematics_presets
from ..looks import KINEMATICS
from ..panel import Document, Panel
from ..picture import Change
from ..readout import reading
from ..values import by_hand, put
from .anchorless_averages import averages
from .anchorless_averages import subject as averaged
from .anchorless_handles import CLEAN, with_vector
from .anchorless_hints import ARROWS, LIMITS, arrow_seconds, interval_of, with_hint
from .anchorless_levels import SENSES
from .anchorless_sweep import over_stamps
from .anchorless_sweep import subject as swept
from .averaging import Kind, averaging_controls
from .choices import Chosen
from .gauge import seen
from .gauge_panel import gauge_controls
from .track_panel import seed_controls

SENSING_FIRST = ("algorithm-2-rank1", "maximum-likelihood-accelerometers")
"""Switched on with the accelerometers."""
SENSING = "All nodes share one unknown frame of their accelerometers, another one in each trial."
NOT_SENSING = "Distances alone: estimators that read accelerations are switched off."
KINDS = (
    Kind("Average over trials", "plots: RMSE over time, two standard errors around it", averages, averaged),
    Kind("Over K", "plots: RMSE over the number of stamps, 200 trials each at most", over_stamps, swept),
)


def anchorless_controls(panel: Panel) -> None:
    """All that estimators of a network depend on."""
    with panel.folder("Stamps and seed", opened=True):
        _stamps(panel)
    with panel.folder("Measurements", opened=True):
        _measurements(panel)
    with panel.folder("Gauge: what distances cannot see", opened=True):
        gauge_controls(panel)
    with panel.folder("Averages over trials", opened=True):
        averaging_controls(panel, KINDS)
    with panel.folder("Estimators", opened=True):
        panel.several("estimators.enabled", [(name, look.label) for name, look in KINEMATICS.items()])
    with panel.folder("Assumptions"):
        panel.number("estimators.degree", "degree L assumed", step=1, least=0, most=8)
        panel.note(on_degree)
        panel.number("estimators.range_degree", "degree q of a range", step=1, least=2, most=16)
    with panel.folder("Nodes at time 0"):
        _nodes(panel)
    with panel.folder("Drawing"):
        _drawing(panel)


def with_accelerometers(enabled: Sequence[str], wanted: bool, usual: Sequence[str] = ()) -> list[str]:
    """The estimators without those that read accelerometers, or with those that are usual of them."""
    chosen = {name for name in enabled if not SENSES[name]}
    if wanted:
        chosen |= {*enabled, *([name for name in usual if SENSES[name]] or SENSING_FIRST)}
    return [name for name in KINEMATICS if name in chosen]


def on_degree(document: Document) -> str:
    """What an assumed degree leaves out."""
    real = len(document["coefficients"]) - 1
    if document["estimators"]["degree"] < real:
        left_out = "what is left out is an error that no number of stamps removes."
        return f"**Mind:** The motion has degree {real}: {left_out}"
    return "Of the motion as a polynomial of time: 2 is constant acceleration. Algorithm 1 takes no other."


def spread_evenly(scenario: Any) -> Any:
    """As many stamps, evenly over the same interval."""
    document = scenario.to_dict()
    first, last = interval_of(document)
    return scenario.replace(
        stamps={"kind": "regular", "first": first, "last": last, "count": len(document["stamps"]["times"])}
    )


def _stamps(panel: Panel) -> None:
    panel.number("stamps.count", "stamps K", step=10, least=1)
    panel.number("stamps.first", "first, s", step=0.5)
    panel.number("stamps.last", "last, s", step=0.5)
    panel.note(_listed)
    evenly = panel.button("Spread them evenly", lambda: panel.edit("stamps", spread_evenly))

    def follow(document: Document) -> None:
        evenly.visible = document["stamps"]["kind"] != "regular"

    panel.on_follow(follow)
    panel.number("steps", "steps played", step=10, least=1)
    seed_controls(panel)


def _listed(document: Document) -> str:
    if document["stamps"]["kind"] == "regular":
        return ""
    first, last = (reading(each) for each in interval_of(document))
    return f"{len(document['stamps']['times'])} stamps as listed in the scenario, from {first} to {last} s."


def _measurements(panel: Panel) -> None:
    panel.number("noise.sigma_distance", "distance σ_d, m", step=0.01, least=0.0)
    panel.number("noise.missing_probability", "missing distances, %", factor=100.0, step=5.0, least=0.0, most=100.0)
    panel.tick("accelerometers", _sensing, lambda wanted: panel.edit("accelerometers", _with_sensing(wanted)))
    panel.number("noise.sigma_acceleration", "acceleration σ_a, m/s²", step=0.001, least=0.0)
    panel.note(lambda document: SENSING if _sensing(document) else NOT_SENSING)


def _sensing(document: Document) -> bool:
    return any(SENSES[name] for name in document["estimators"]["enabled"])


def _with_sensing(wanted: bool) -> Change:
    def change(scenario: Any) -> Any:
        document = scenario.to_dict()
        known = document["name"] in {each["name"] for each in kinematics_presets()}
        preset = KinematicsScenario.preset(document["name"]).to_dict() if known else document
        enabled = with_accelerometers(document["estimators"]["enabled"], wanted, preset["estimators"]["enabled"])
        return scenario.replace({"estimators.enabled": enabled})

    return change


class SeenNode(Chosen):
    """The coordinates of a node as they are seen: the gauge turns them, and what is typed is turned back."""

    def value(self, document: Document, path: str, missing: Any = None) -> Any:
        """A place, or a derivative."""
        order, n = self._indices(path)
        coefficients = seen(document)
        return (np.round(coefficients[order, n], CLEAN) + 0.0).tolist() if order < len(coefficients) else missing

    def put(self, path: str, value: Any) -> None:
        """An edit of it."""
        self.edit(self.at(path), with_vector(*self._indices(path), value))

    def _indices(self, path: str) -> tuple[int, int]:
        order, n = re.findall(r"\d+", self.at(path))
        return int(order), int(n)


def _nodes(panel: Panel) -> None:
    chosen = SeenNode(panel, "node", lambda document: [f"N{n + 1}" for n in range(len(document["coefficients"][0]))])
    for order, label in enumerate(("position, m", "velocity, m/s", "acceleration, m/s²")):
        chosen.vector(f"coefficients[{order}][#]", label, step=1.0 if order == 0 else 0.1)
    chosen.act("Remove the node", _without)
    panel.button("Add a node", lambda: panel.edit("node", _with_node))


def _with_node(scenario: Any) -> Any:
    """One more node, off the middle of the others, that moves as they do on the average."""
    coefficients = np.array(scenario.to_dict()["coefficients"])
    new = coefficients.mean(axis=1, keepdims=True)
    new[0] += 0.1 * np.ptp(coefficients[0], axis=0)
    return scenario.replace(coefficients=np.concatenate([coefficients, new.round(3)], axis=1))


def _without(index: int) -> Change:
    return lambda scenario: scenario.replace(
        coefficients=np.delete(np.array(scenario.to_dict()["coefficients"]), index, axis=1)
    )


def _drawing(panel: Panel) -> None:
    least, most = LIMITS[ARROWS]
    handle = panel.gui.add_number("arrows reach, s", 1.0, min=least, max=most, step=5.0)
    handle.precision = CLEAN
    by_hand(handle, lambda seconds: panel.edit("arrows", with_hint(ARROWS, float(seconds))))
    panel.on_follow(lambda document: put(handle, arrow_seconds(document)))
