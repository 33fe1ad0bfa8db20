"""The controls of the lab Explore: the bound as a landscape, the body, where anchors should stand, walls and boxes."""

from ..panel import Panel
from .anchors import anchor_controls
from .body_designer import body_controls, mounting_control, sensor_controls, unknown_to_all
from .field_panel import field_controls
from .noise import noise_controls
from .obstacles import obstacle_controls
from .orientation import start_controls
from .placement import placement_controls
from .track_panel import fan_control


def explore_controls(panel: Panel) -> None:
    """All that the bound of one epoch depends on."""
    with panel.folder("Bound over a plane", opened=True):
        field_controls(panel)
        fan_control(panel)
    with panel.folder("Body", opened=True):
        body_controls(panel)
    with panel.folder("Pose of the body"):
        start_controls(panel)
    _room(panel)
    with panel.folder("Ranges"):
        noise_controls(panel)


def bound_controls(panel: Panel) -> None:
    """The bound beside other labs, and the room."""
    with panel.folder("Bound over a plane", opened=True):
        field_controls(panel)
    _room(panel)
    with panel.folder("Sensors on the body"):
        sensor_controls(panel)
        mounting_control(panel, unknown_to_all)


def _room(panel: Panel) -> None:
    with panel.folder("Placement", opened=True):
        placement_controls(panel)
    with panel.folder("Walls and boxes", opened=True):
        obstacle_controls(panel)
    with panel.folder("Anchors"):
        anchor_controls(panel)
