"""The controls of the page's lab Localize."""

from typing import Any

from ..looks import LOCALIZERS
from ..panel import Document, Panel
from ..readout import reading
from ..values import by_hand, put
from .anchors import anchor_controls
from .body_designer import mounting_control, position_floor, sensor_controls
from .noise import noise_controls
from .noise_sweep import sweep_controls
from .orientation import start_controls
from .track_panel import seed_controls

TRIALS, MOST_TRIALS = 50, 500
LOSS, SIGMA = "localize.loss", "localize.tls_sigma"
LOSSES: dict[str, dict[str, Any]] = {"squared": {"kind": "squared"}, "huber": {"kind": "huber", "scale": 1.345}}
FIRST_SIGMA = 0.1


def cloud_of(document: Document) -> int:
    """Trials of the cloud, a hint of the page that travels with the scenario; hints may be anything."""
    hint = (document["view"] or {}).get("cloud")
    return hint if type(hint) is int and 1 <= hint <= MOST_TRIALS else TRIALS


def localize_controls(panel: Panel) -> None:
    """What the estimates depend on, what a lecture changes most first."""
    with panel.folder("Ranges", opened=True):
        noise_controls(panel)
        panel.choice("weights", "weights", (("measured", "measured"), ("true", "true")))
    with panel.folder("Localizers", opened=True):
        panel.several("localize.enabled", [(name, look.label) for name, look in LOCALIZERS.items()])
    with panel.folder("Sweep of the noise", opened=True):
        sweep_controls(panel)
    with panel.folder("Localizer settings", opened=True):
        _settings(panel)
    with panel.folder("Trials and seed", opened=True):
        _trials(panel)
    with panel.folder("Topology perturbation"):
        mounting_control(panel, mounting_told)
        panel.optional(
            "OUC-TLS assumes its own σ_e, m",
            lambda document: panel.value(document, SIGMA),
            lambda value: panel.put(SIGMA, value),
            first=FIRST_SIGMA,
        )
    with panel.folder("Pose of the body"):
        start_controls(panel)
    with panel.folder("Sensors on the body"):
        sensor_controls(panel)
    with panel.folder("Anchors"):
        anchor_controls(panel)


def _settings(panel: Panel) -> None:
    panel.choice("localize.manifold", "group", (("so", "SO(D)"), ("o", "O(D)")))
    panel.note(_group_told)
    losses = (("squared", "squared"), ("huber", "Huber"))
    panel.chooser(
        "loss of ML",
        losses,
        lambda found: str(found["localize"]["loss"]["kind"]),
        lambda kind: panel.put(LOSS, LOSSES[kind]),
    )
    panel.number("localize.loss.scale", "linear beyond, σ", step=0.1, least=0.0)
    panel.switch(
        "localize.multi_start",
        "25 Newton starts",
        hint="where an optimum cannot be certified, OUC-LS and OUC-TLS are searched for from 24 more starts",
    )


def _trials(panel: Panel) -> None:
    cloud = panel.gui.add_number("trials of the cloud", TRIALS, min=1, max=MOST_TRIALS, step=10)

    def change(scenario: Any, trials: int) -> Any:
        return scenario.replace(view={**(scenario.to_dict()["view"] or {}), "cloud": trials})

    by_hand(cloud, lambda trials: panel.edit("cloud", lambda scenario: change(scenario, int(trials))))
    panel.on_follow(lambda document: put(cloud, cloud_of(document)))
    panel.tick(
        "dots at the tips of the axes", lambda _: panel.studio.wish.fans, lambda ticked: panel.studio.ask(fans=ticked)
    )
    seed_controls(panel)


def _group_told(document: Document) -> str:
    if document["localize"]["manifold"] == "o":
        return "As in the paper: reflections fit the ranges too, and are drawn dashed. ML takes rotations all the same."
    return f"Rotations only, in D = {document['dimension']} dimensions: no localizer but LS can mirror the body."


def mounting_told(document: Document) -> str:
    """What a topology off its places costs here, where the bounds and the total least squares know of it."""
    sigma, assumed = document["mounting_sigma"], document["localize"]["tls_sigma"]
    told = []
    if sigma > 0:
        told.append(
            f"Every trial puts each sensor a little elsewhere: positions stay about {position_floor(document)} m off, "
            "however good the ranges. Bounds and OUC-TLS know of it."
        )
    if assumed is not None and assumed != sigma:
        told.append(f"OUC-TLS assumes {reading(assumed)} m; it really is {reading(sigma)} m.")
    return " ".join(told)
