"""The body designer: presets, sizes and sensors of the body, and what the last change of it was worth."""

from collections.abc import Callable
from html import escape
from typing import Any, cast

import numpy as np
import viser

from ...arrays import Floats
from ...scenario import Scenario, topologies
from ..panel import Document, Panel
from ..picture import Change, Wish
from ..readout import reading
from ..values import by_hand, put
from .choices import Chosen
from .explore import ExplorePicture
from .size_curve import size_of

OWN = "of its own"
LIKE = 1e-4
"""Sensors nearer than this share of the body to those of a preset are that preset."""
SAME = 5e-4
"""Below this share nothing has changed but roundings."""
FACTOR = 3.0
"""So much larger a bound is told as a factor: percentages of that size say nothing."""
ROWS = (("orientation, deg", "angle_sigma", float(np.degrees(1.0))), ("position, m", "position_sigma", 1.0))


def body_controls(panel: Panel) -> None:
    """The bounds and their change, presets, the size, one sensor at a time, how exactly sensors sit."""
    _bounds(panel)
    panel.gui.add_markdown("Drag the sensors S1, S2 … on the bench beside the room, or type where they sit.")
    _topology(panel)
    _size(panel)
    panel.note(lambda _: _size_told(panel))
    sensor_controls(panel)
    mounting_control(panel, unknown_to_all)


def mounting_control(panel: Panel, told: Callable[[Document], str]) -> None:
    """How exactly sensors sit, and what that costs."""
    panel.number("mounting_sigma", "mounting error σ_e, m", step=0.01, least=0.0, hint="of each coordinate, one σ")
    panel.note(told)


def sensor_controls(panel: Panel) -> None:
    """Where each sits, in the frame of the body."""
    chosen = Chosen(panel, "sensor", lambda document: [f"S{n + 1}" for n in range(len(document["sensors"]))])
    chosen.vector("sensors[#]", "position, m", step=0.05)
    chosen.act("Remove the sensor", _without_sensor)
    panel.button("Add a sensor", lambda: panel.edit("sensor", with_sensor))


def topology_of(sensors: Floats) -> str:
    """The name of the body that sensors (N x D, m) make in whatever size; OWN where it is none of those with a name."""
    size = size_of(sensors)
    for body in topologies(sensors.shape[1]):
        shape = size * np.array(body["sensors"])
        if shape.shape == sensors.shape and np.linalg.norm(shape - sensors, axis=1).max() < LIKE * size:
            return str(body["name"])
    return OWN


def scaled(sensors: Floats, size: float) -> list[list[float]]:
    """The same body in another size, m."""
    return [[float(f"{value:.9g}") + 0.0 for value in each] for each in sensors * size / size_of(sensors)]


def with_sensor(scenario: Any) -> Any:
    """One more sensor, beside the last one, so that it is seen."""
    sensors = np.array(scenario.to_dict()["sensors"])
    new = sensors[-1].copy()
    new[0] = float(f"{new[0] + (size_of(sensors) / 2 or 0.1):.3g}")
    return scenario.replace(sensors=[*sensors.tolist(), new.tolist()])


def compared(now: float | None, before: float | None) -> str:
    """How a bound is against before, as in "14 % better"."""
    if now is None:
        return "none" if before is None else "lost"
    if before is None:
        return "new"
    share = abs(now / before - 1)
    if share < SAME:
        return "the same"
    if now >= FACTOR * before:
        return f"{reading(now / before)} × worse"
    return f"{100 * share:.{1 if share < 0.095 else 0}f} % {'better' if now < before else 'worse'}"


def before_the_body_changed(now: Scenario, before: Wish | None) -> Scenario | None:
    """The scenario before the last edit, where that was one of the body and of nothing else."""
    if before is None or not isinstance(before.source, Scenario) or before.source.dimension != now.dimension:
        return None
    with_this_body = before.source.replace(sensors=now.sensors, mounting_sigma=now.to_dict()["mounting_sigma"])
    return before.source if with_this_body == now and before.source != now else None


def _bounds(panel: Panel) -> None:
    """The bounds of the body, and what its last change was worth."""
    told = panel.gui.add_html("")

    def follow(_: Document) -> None:
        source = panel.studio.wish.source
        if isinstance(source, Scenario):
            before = before_the_body_changed(source, panel.studio.before)
            shown = panel.studio.good
            known = isinstance(shown, ExplorePicture) and shown.scenario is source
            told.content = _table(shown.run if known else source.explore(), before.explore() if before else None)

    panel.on_follow(follow)


def _table(now: dict[str, Any], before: dict[str, Any] | None) -> str:
    cell = "padding:0 0 0 0.6rem;text-align:right"
    rows = ""
    for name, key, factor in ROWS:
        number = "–" if now[key] is None else reading(factor * now[key])
        change = "" if before is None else compared(now[key], before[key])
        rows += f"<tr><th scope=row style='text-align:left;font-weight:400'>{name}</th>"
        rows += f"<td style='{cell}'><b>{number}</b></td><td style='{cell}'>{escape(change)}</td></tr>"
    heads = "".join(f"<th scope=col style='{cell};font-weight:400'>{head}</th>" for head in ("now", "change"))
    return (
        "<div style='padding:0 0.75rem 0.3rem;font-size:0.8rem'><table style='width:100%;"
        "border-collapse:collapse;font-variant-numeric:tabular-nums'><thead><tr><th scope=col style='text-align:left'>"
        f"Bound</th>{heads}</tr></thead><tbody>{rows}</tbody></table></div>"
    )


def _topology(panel: Panel) -> None:
    """Which of the bodies with a name it is; another one comes in the same size."""
    names: viser.GuiDropdownHandle[str] = panel.gui.add_dropdown("body", cast("tuple[str, ...]", (OWN,)))

    def follow(document: Document) -> None:
        options = (OWN, *(body["name"] for body in topologies(document["dimension"])))
        if options != tuple(names.options):
            names.options = options
        put(names, topology_of(np.array(document["sensors"])))

    def choose(name: str) -> None:
        document = panel.studio.document
        if isinstance(document, Scenario) and name != OWN:
            shapes = {body["name"]: np.array(body["sensors"]) for body in topologies(document.dimension)}
            new = scaled(shapes[name], size_of(document.sensors) or 1.0)
            panel.edit("body", lambda scenario: scenario.replace(sensors=new))

    by_hand(names, choose)
    panel.on_follow(follow)


def _size(panel: Panel) -> None:
    """The largest distance between two sensors."""
    box = panel.gui.add_number("size, m", 1.0, min=1e-6, step=0.05, hint="the largest distance between two sensors")
    box.precision = 9

    def follow(document: Document) -> None:
        size = size_of(np.array(document["sensors"]))
        box.visible = size > 0
        if size > 0:
            put(box, float(f"{size:.9g}"))

    by_hand(box, lambda size: panel.edit("size", lambda found: found.replace(sensors=scaled(found.sensors, size))))
    panel.on_follow(follow)


def _size_told(panel: Panel) -> str:
    """What the plot of the sizes shows, where there is one."""
    picture = panel.studio.good
    return picture.sizes.sentence() if isinstance(picture, ExplorePicture) else ""


def position_floor(document: Document) -> str:
    """The position that least squares finds is off by this, however good the ranges are (one σ), m."""
    return reading(float(document["mounting_sigma"] * np.sqrt(document["dimension"] / len(document["sensors"]))))


def unknown_to_all(document: Document) -> str:
    """What a mounting error costs where nobody is told of it."""
    if document["mounting_sigma"] == 0:
        return ""
    return (
        "Every trial puts each sensor a little elsewhere, and neither trackers nor bounds know of it: positions of "
        f"single epochs stay about {position_floor(document)} m off. Balls on the bench hold 95 % of its places."
    )


def _without_sensor(index: int) -> Change:
    def change(scenario: Any) -> Any:
        sensors = scenario.to_dict()["sensors"]
        return scenario.replace(sensors=[each for n, each in enumerate(sensors) if n != index])

    return change
