"""The controls of a recording: which trackers run over it. Its measurements are what they are."""

from ..looks import TRACKERS
from ..panel import Panel
from ..values import by_hand


def replay_controls(panel: Panel) -> None:
    """A box for each tracker."""
    with panel.folder("Estimators", opened=True):
        wished = panel.studio.wish.estimators
        boxes = {
            name: panel.gui.add_checkbox(look.label, wished is None or name in wished)
            for name, look in TRACKERS.items()
        }
    for box in boxes.values():
        by_hand(
            box,
            lambda _: panel.studio.ask(estimators=tuple(name for name, each in boxes.items() if each.value)),
        )
