"""The controls of the page's lab Track: what a lecture changes most comes first."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..looks import TRACKERS
from ..panel import DEGREES, Document, Panel
from .averaging import AVERAGES, Kind, averaging_controls
from .noise import noise_controls
from .orientation import orientation_control
from .paths import PATHS, with_path
from .track_budget import budget
from .track_budget import subject as budget_subject
from .track_draws import MOST, anchor_draws
from .track_draws import subject as draws_subject
from .way_points import way_point_controls

STUDIES = (
    AVERAGES,
    Kind("ET budget", "plots: what projections of the ET-KF cost and buy, at 21 thresholds", budget, budget_subject),
    Kind(
        "Anchor draws",
        f"plots: anchors drawn anew against fixed ones; {MOST} draws at most",
        anchor_draws,
        draws_subject,
    ),
)
Options = Sequence[tuple[str, str]]


def track_controls(panel: Panel) -> None:
    """All of a scenario that trackers depend on."""
    with panel.folder("Ranges", opened=True):
        noise_controls(panel)
        panel.number("missing_probability", "missing ranges, %", factor=100.0, step=5.0, least=0.0, most=100.0)
    with panel.folder("Weights of ranges"):
        panel.choice("weights", "weights", (("measured", "measured"), ("true", "true")))
        panel.choice("weighting", "weighting", (("common", "per anchor"), ("per_pair", "per range")))
    with panel.folder("Estimators", opened=True):
        panel.several("estimators.enabled", [(name, look.label) for name, look in TRACKERS.items()])
        fan_control(panel)
        panel.number("estimators.threshold.epsilon", "ET threshold ε", step=0.01, least=0.0)
    with panel.folder("Studies of many trials", opened=True):
        averaging_controls(panel, STUDIES)
    with panel.folder("Estimator settings"):
        _estimator_settings(panel)
    with panel.folder("Time and seed", opened=True):
        seed_controls(panel)
        panel.number("steps", "steps", step=10, least=1)
        panel.number("interval", "interval, s", step=0.1, least=0.0)
    with panel.folder("Process noise"):
        panel.number("process.sigma_q", "turn per step σ_q, deg", factor=DEGREES, step=0.1, least=0.0)
        panel.number("process.sigma_t", "shift per step σ_t, m", step=0.01, least=0.0)
        panel.button("Match the truth", lambda: panel.edit("match", matched_to_truth))
    with panel.folder("Motion of the body"):
        _motion(panel)
    with panel.folder("Start and first guess"):
        _start(panel)


def fan_control(panel: Panel) -> None:
    """What is claimed of the orientation, drawn."""
    panel.tick("fans of the axes, 95 %", lambda _: panel.studio.wish.fans, lambda ticked: panel.studio.ask(fans=ticked))


def seed_controls(panel: Panel) -> None:
    """Which random numbers."""
    panel.number("seed", "seed", step=1, least=0)
    panel.button("Other random numbers", lambda: panel.put("seed", int(np.random.default_rng().integers(2**16))))


def matched_to_truth(scenario: Any) -> Any:
    """The process noise that the motion really has."""
    document = scenario.to_dict()
    motion = document["motion"]
    assumed = {"sigma_q": motion["sigma_omega"] * document["interval"], "sigma_t": motion["sigma_t"]}
    return scenario.replace(process=assumed)


def guessing_the_truth(scenario: Any) -> Any:
    """The filters' first guess is the true start."""
    document = scenario.to_dict()
    return scenario.replace(initial={**document["initial"], **document["start"]})


def _estimator_settings(panel: Panel) -> None:
    of = "estimators."
    panel.switch(of + "feedback", "projected Q is fed back")
    panel.choice(of + "threshold.kind", "threshold", (("absolute", "ε"), ("relative", "ε √(tr P)")))
    panel.choice(of + "metric", "metric", (("frobenius", "Frobenius"), ("information", "P⁻¹")))
    panel.choice(of + "manifold", "manifold", (("so", "SO(D)"), ("o", "O(D)")))
    panel.switch(of + "decoupled", "UC-KF solves for Q, then for t")


def _motion(panel: Panel) -> None:
    panel.chooser("path", PATHS, _kind, lambda kind: panel.edit("path", with_path(kind)))
    panel.number("motion.path.radius", "radius, m", step=0.1, least=0.0)
    panel.number("motion.path.period", "period, s", step=0.5, least=0.0)
    panel.number("motion.path.climb", "climb a turn, m", step=0.1)
    panel.choice("motion.path.side", "turns", (("left", "left"), ("right", "right")))
    way_point_controls(panel)
    panel.vector("motion.velocity", "velocity, m/s", step=0.1)
    panel.vector("motion.angular_velocity", "turn rate, deg/s", factor=DEGREES, step=1.0)
    panel.number("motion.sigma_omega", "turn rate disturbed by σ_ω, deg/s", factor=DEGREES, step=0.1, least=0.0)
    panel.number("motion.sigma_t", "shift per step σ_t, m", step=0.01, least=0.0)


def _kind(document: Document) -> str:
    path = document["motion"]["path"]
    return "none" if path is None else str(path["kind"])


def _start(panel: Panel) -> None:
    panel.vector("start.position", "position, m", step=0.1)
    orientation_control(panel, "start.orientation", "orientation")
    panel.vector("initial.position", "guessed position, m", step=0.1)
    orientation_control(panel, "initial.orientation", "guessed orientation")
    panel.number("initial.covariance", "variance of the guess, of each entry of [Q | t]", step=1.0, least=0.0)
    panel.button("Guess the true start", lambda: panel.edit("guess", guessing_the_truth))
