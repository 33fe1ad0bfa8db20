"""Handles in the scene that are dragged, each drag one gesture."""

from collections.abc import Callable

import numpy as np
import viser

from ..arrays import Floats
from . import shapes
from .picture import Change, Handle
from .themes import Theme
from .values import in_order

Dragged = Callable[[Change, str], None]
"""Told the edit, and the gesture it belongs to."""
ARROWS = 0.11
"""Length of the arrows of a handle beside the scene."""
LINE = 2.0
"""Of arrows, pixels."""
ANYWHERE = (-1e9, 1e9)


class Gizmos:
    """The handles of one server's scene."""

    def __init__(self, server: viser.ViserServer, theme: Theme, dragged: Dragged) -> None:
        self._server, self._theme, self._dragged = server, theme, dragged
        self._known: dict[str, tuple[Handle, viser.TransformControlsHandle]] = {}
        self._held: str | None = None
        self._drags = 0

    def recolour(self, theme: Theme) -> None:
        """Makes them anew in other colours."""
        self._theme = theme
        self.clear()

    def clear(self) -> None:
        """Takes all away."""
        for name in list(self._known):
            self._known.pop(name)[1].remove()

    def show(self, handles: list[Handle], extent: float) -> None:
        """Puts the handles where they are; the one in a hand stays where the hand is."""
        for name in self._known.keys() - {handle.name for handle in handles}:
            self._known.pop(name)[1].remove()
        for handle in handles:
            known = self._known.get(handle.name)
            if known is not None and known[0].fixed != handle.fixed:
                known[1].remove()
                known = None
            node = self._made(handle, extent) if known is None else known[1]
            if known is not None and self._held == handle.name:
                # What a place means stays as it was when the hand took hold.
                continue
            self._known[handle.name] = (handle, node)
            place = shapes.lifted(handle.place)
            if not np.array_equal(node.position, place):
                node.position = place
            if handle.orientation is not None:
                node.wxyz = shapes.quaternion(handle.orientation)

    def _made(self, handle: Handle, extent: float) -> viser.TransformControlsHandle:
        scene, d = self._server.scene, len(handle.place)
        free = tuple(not fixed and axis < d for axis, fixed in enumerate(handle.fixed))
        node = scene.add_transform_controls(
            handle.name,
            scale=ARROWS * handle.size * extent,
            disable_rotations=handle.orientation is None,
            disable_axes=not any(free),
            # Squares would hide the body that is turned.
            disable_sliders=not any(free) or (handle.orientation is not None and d == 3),
            line_width=LINE,
            active_axes=(free[0], free[1], free[2]),
            translation_limits=(ANYWHERE, ANYWHERE, ANYWHERE),
            depth_test=False,
            position=shapes.lifted(handle.place),
        )
        if handle.orientation is None:
            size = 0.018 * handle.size * extent
            scene.add_box(f"{handle.name}/mark", dimensions=(size, size, size), color=self._theme.rgb(handle.token))
        if handle.label:
            scene.add_label(f"{handle.name}/label", handle.label, font_screen_scale=self._theme.letters)

        @node.on_update
        async def _(event: viser.TransformControlsEvent) -> None:
            place, wxyz = (np.array(each, dtype=np.float64) for each in (node.position, node.wxyz))
            in_order(self._moved, handle.name, event.phase, place, wxyz)

        return node

    def _moved(self, name: str, phase: str, place: Floats, wxyz: Floats) -> None:
        if phase == "start":
            self._drags += 1
        self._held = None if phase == "end" else name
        known = self._known.get(name)
        if known is not None:
            d = len(known[0].place)
            self._dragged(known[0].moved(place[:d], shapes.rotation(wxyz, d)), f"drag {self._drags}")
