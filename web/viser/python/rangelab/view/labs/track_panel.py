"""The controls of the page's lab Track: what a lecture changes most comes first."""

from functools import partial
from typing import Any

import numpy as np

from ...run import Run
from ..looks import TRACKERS
from ..panel import DEGREES, Document, Panel
from . import track_cautions as cautions
from .averaging import AVERAGES, Kind, averaging_controls
from .noise import median_distance, median_range, noise_controls
from .orientation import orientation_control, start_controls
from .paths import PATHS, with_path
from .paths import told as told_of_path
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
RAW = (
    "Whether ‖s‖² is projected out of the squared ranges is a choice between estimators: ESKF does so as all the "
    "others do, ESKF raw does not."
)


def track_controls(panel: Panel) -> None:
    """All of a scenario that trackers depend on."""

    def distance(document: Document) -> float:
        return _median_range(panel, document)

    with panel.folder("Ranges", opened=True):
        noise_controls(panel, distance)
        panel.number("missing_probability", "missing ranges, %", factor=100.0, step=5.0, least=0.0, most=100.0)
    with panel.folder("Weights of ranges"):
        panel.choice("weights", "weights", (("measured", "measured"), ("true", "true")))
        panel.note(cautions.on_weights)
        panel.choice("weighting", "weighting", (("common", "per anchor"), ("per_pair", "per range")))
        panel.note(lambda document: cautions.on_weighting(document, distance(document)))
    with panel.folder("Estimators", opened=True):
        panel.several("estimators.enabled", [(name, look.label) for name, look in TRACKERS.items()])
        fan_control(panel)
        panel.number("estimators.threshold.epsilon", "ET threshold ε", step=0.01, least=0.0)
        panel.note(cautions.on_zero_threshold)
    with panel.folder("Studies of many trials", opened=True):
        averaging_controls(panel, STUDIES)
    with panel.folder("Estimator settings"):
        _estimator_settings(panel)
    with panel.folder("Time and seed", opened=True):
        seed_controls(panel)
        panel.number("steps", "steps", step=10, least=1)
        panel.number("interval", "interval, s", step=0.1, least=0.0)
    with panel.folder("Process noise"):
        _process(panel)
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


def _median_range(panel: Panel, document: Document) -> float:
    """Along the run that is shown, else at its start, m."""
    run = panel.studio.good.run
    known = isinstance(run, Run) and np.isfinite(run.truth_positions).all()
    return median_distance(run.anchors, run.truth_positions) if known else median_range(document)


def _estimator_settings(panel: Panel) -> None:
    of = "estimators."
    panel.switch(of + "feedback", "projected Q is fed back")
    panel.note(cautions.on_feedback)
    panel.choice(of + "threshold.kind", "threshold", (("absolute", "ε"), ("relative", "ε √(tr P)")))
    panel.note(cautions.on_threshold)
    panel.choice(of + "metric", "metric", (("frobenius", "Frobenius"), ("information", "P⁻¹")))
    panel.note(cautions.on_metric)
    panel.choice(of + "manifold", "manifold", (("so", "SO(D)"), ("o", "O(D)")))
    panel.note(cautions.on_manifold)
    panel.switch(of + "decoupled", "UC-KF solves for Q, then for t")
    panel.note(cautions.on_decoupling)
    panel.note(lambda _: RAW)


def _process(panel: Panel) -> None:
    panel.number("process.sigma_q", "turn per step σ_q, deg", factor=DEGREES, step=0.1, least=0.0)
    panel.number("process.sigma_t", "shift per step σ_t, m", step=0.01, least=0.0)
    match = panel.button("Match the truth", lambda: panel.edit("match", matched_to_truth))

    def follow(document: Document) -> None:
        match.disabled = not cautions.on_process_noise(document).startswith(cautions.WARNING)

    panel.on_follow(follow)
    panel.note(cautions.on_process_noise)
    panel.note(lambda _: _on_linear_bound(panel.studio.good.run))


def _on_linear_bound(run: Any) -> str:
    return cautions.on_linear_bound(run) if isinstance(run, Run) else ""


def _motion(panel: Panel) -> None:
    for dimension in (2, 3):
        options = [(kind, label) for kind, label in PATHS if dimension == 3 or kind != "helix"]
        panel.chooser("path", options, partial(_kind, dimension), lambda kind: panel.edit("path", with_path(kind)))
    panel.number("motion.path.radius", "radius, m", step=0.1, least=0.0)
    panel.number("motion.path.period", "period, s", step=0.5, least=0.0)
    panel.number("motion.path.climb", "climb a turn, m", step=0.1)
    panel.choice("motion.path.side", "turns", (("left", "left"), ("right", "right")))
    way_point_controls(panel)
    panel.note(told_of_path)
    panel.vector("motion.velocity", "velocity, m/s", step=0.1)
    panel.vector("motion.angular_velocity", "turn rate, deg/s", factor=DEGREES, step=1.0)
    panel.number("motion.sigma_omega", "turn rate disturbed by σ_ω, deg/s", factor=DEGREES, step=0.1, least=0.0)
    panel.number("motion.sigma_t", "shift per step σ_t, m", step=0.01, least=0.0)


def _kind(dimension: int, document: Document) -> str | None:
    """The plane has no height for a helix to climb."""
    if document["dimension"] != dimension:
        return None
    path = document["motion"]["path"]
    return "none" if path is None else str(path["kind"])


def _start(panel: Panel) -> None:
    start_controls(panel)
    panel.vector("initial.position", "guessed position, m", step=0.1)
    orientation_control(panel, "initial.orientation", "guessed orientation")
    panel.note(cautions.on_guess)
    panel.number("initial.covariance", "variance of the guess, of each entry of [Q | t]", step=1.0, least=0.0)
    panel.note(cautions.on_prior)
    panel.button("Guess the true start", lambda: panel.edit("guess", guessing_the_truth))
