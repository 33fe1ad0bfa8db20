"""The whole network turned, mirrored and shifted, and the numbers that show that no distance changes."""

from typing import Any

from ..panel import Document, Panel
from ..readout import reading
from ..values import by_hand, put
from .anchorless_hints import interval_of
from .gauge import evidence_of, gauge_of, with_gauge

NONE = "What distances cannot see: turn, mirror or shift all nodes, and none changes."
ROUNDING = (
    "Rounding only, so errors from distances stay as they are. Accelerometers have a frame of their own: "
    "their noise falls otherwise on a turned network."
)


def gauge_controls(panel: Panel) -> None:
    """What is seen changes, what is estimated does not."""
    _turn(panel)
    panel.tick(
        "mirror all nodes in x",
        lambda document: gauge_of(document).mirrored,
        lambda ticked: panel.edit("mirror", with_gauge(mirrored=ticked)),
    )
    _shift(panel)
    panel.note(_evidence)
    panel.button("Show it as it is", lambda: panel.edit("gauge", _untouched), hint="not turned, mirrored or shifted")


def _turn(panel: Panel) -> None:
    slider = panel.gui.add_slider("turn all nodes, deg", -180.0, 180.0, 1.0, 0.0)
    by_hand(slider, lambda degrees: panel.edit("turn", with_gauge(degrees=float(degrees))))
    # A link may have turned it more than half around.
    panel.on_follow(lambda document: put(slider, _half_around(gauge_of(document).degrees)))


def _shift(panel: Panel) -> None:
    boxes: dict[int, Any] = {
        2: panel.gui.add_vector2("shift all nodes, m", (0.0, 0.0), step=100.0, visible=False),
        3: panel.gui.add_vector3("shift all nodes, m", (0.0, 0.0, 0.0), step=100.0, visible=False),
    }

    def follow(document: Document) -> None:
        shift = tuple(gauge_of(document).shift)
        for count, box in boxes.items():
            box.visible = count == len(shift)
        put(boxes[len(shift)], shift)

    for box in boxes.values():
        by_hand(box, lambda way: panel.edit("shift", with_gauge(shift=[float(each) for each in way])))
    panel.on_follow(follow)


def _evidence(document: Document) -> str:
    if gauge_of(document).is_identity:
        return NONE
    found = evidence_of(document, [*interval_of(document), 0.0])
    return (
        f"Largest change of a distance: **{reading(found.distance)} m**, "
        f"of the length of an arrow: **{reading(found.arrow)} m/s, m/s²**. "
        f"Arrows turn alike to **{reading(found.turn)}°**. {ROUNDING}"
    )


def _untouched(scenario: Any) -> Any:
    return with_gauge(degrees=0.0, mirrored=False, shift=[0.0] * len(gauge_of(scenario.to_dict()).shift))(scenario)


def _half_around(degrees: float) -> float:
    return degrees if abs(degrees) <= 180 else (degrees + 180) % 360 - 180
