"""What surrounds the drawing: light, floor, background, the first camera."""

import numpy as np
import viser

from ..arrays import Floats
from . import shapes
from .themes import Theme

UPRIGHT = 1e-9
"""A scene lower than this part of its width is one of the plane."""
FILL = 0.84
"""Share of the half width or height that the outermost points may take."""
ASPECT = 1.1
"""Width over height of the scene where no browser has told its own yet."""
RESIZED = 0.02
"""Aspects that differ by more are those of another window."""
BELOW = 2e-3
"""The floor lies so much lower, beside the scene: what lies on it is seen whole."""


class Stage:
    """The surroundings of one server's scene."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._outline = np.zeros((1, 3))
        self._seen: dict[int, tuple[float, Floats]] = {}
        """For each browser the aspect of its window, and where the camera was put for it."""
        server.scene.set_up_direction("+z")
        server.scene.configure_default_lights(cast_shadow=False)
        server.on_client_connect(self._connected)

    def dress(self, theme: Theme) -> None:
        """The colours of the browser's own parts and of the background."""
        self._server.gui.configure_theme(
            dark_mode=theme.dark, brand_color=theme.rgb("accent"), show_share_button=False, show_logo=False
        )
        self._server.scene.set_background_image(np.full((2, 2, 3), theme.rgb("scene"), dtype=np.uint8), format="png")

    def frame(self, outline: Floats, theme: Theme, *, camera: bool = True) -> None:
        """Lays the floor and looks at the whole outline (P x D, m)."""
        self._outline = shapes.lifted(shapes.known(outline))
        low, high = self._outline.min(axis=0), self._outline.max(axis=0)
        centre, size = (low + high) / 2, self._size
        cell = 10.0 ** np.floor(np.log10(size / 3))
        self._server.scene.add_grid(
            "/grid",
            width=2 * size,
            height=2 * size,
            cell_size=cell,
            section_size=5 * cell,
            cell_color=theme.rgb("grid"),
            section_color=theme.rgb("grid"),
            fade_distance=20 * size,
            position=(centre[0], centre[1], min(0.0, low[2]) - BELOW * size),
        )
        if not camera:
            return
        initial = self._server.initial_camera
        target, place = seen_whole(self._outline, initial.fov, ASPECT)
        initial.look_at, initial.position, initial.up = tuple(target), tuple(place), (0.0, 0.0, 1.0)
        initial.near, initial.far = 1e-3 * size, 1e2 * size
        for client in self._server.get_clients().values():
            self._look(client)

    @property
    def _size(self) -> float:
        return float(np.linalg.norm(np.ptp(self._outline, axis=0))) or 1.0

    def _connected(self, client: viser.ClientHandle) -> None:
        self._look(client)
        # Panels are docked only after that, and windows change their sizes.
        client.camera.on_update(lambda _: self._resized(client))

    def _resized(self, client: viser.ClientHandle) -> None:
        """Looks at the whole again, unless a hand has moved the camera."""
        aspect, place = self._seen[client.client_id]
        camera = client.camera
        untouched = np.allclose(camera.position, place, atol=1e-3 * self._size)
        if untouched and abs(camera.aspect / aspect - 1) > RESIZED:
            self._look(client)

    def _look(self, client: viser.ClientHandle) -> None:
        """A browser's own window is as wide as it is."""
        camera = client.camera
        target, place = seen_whole(self._outline, camera.fov, camera.aspect)
        self._seen[client.client_id] = camera.aspect, place
        with client.atomic():
            camera.up_direction, camera.position, camera.look_at = (0.0, 0.0, 1.0), place, target
            camera.near, camera.far = 1e-3 * self._size, 1e2 * self._size


def seen_whole(outline: Floats, fov: float, aspect: float) -> tuple[Floats, Floats]:
    """Where a camera looks to and from, just far enough to see all points (P x 3, m); `fov` is upright, rad."""
    low, high = outline.min(axis=0), outline.max(axis=0)
    flat = high[2] - low[2] <= UPRIGHT * float(np.linalg.norm(high - low))
    away = np.array([0.0, -0.15, 1.0]) if flat else np.array([0.25, -1.0, 0.75])
    backward = away / np.linalg.norm(away)
    right = np.cross([0.0, 0.0, 1.0], backward)
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(backward, right), backward])
    across = outline @ axes.T
    middle = (across.min(axis=0) + across.max(axis=0)) / 2
    sides = np.abs(across - middle)
    tangent = FILL * np.tan(fov / 2)
    needed = np.maximum(sides[:, 0] / (tangent * aspect), sides[:, 1] / tangent) + (across - middle)[:, 2]
    target = middle @ axes
    return target, target + max(float(needed.max()), 1e-3) * backward
