"""What surrounds the drawing: light, floor, background, the first camera."""

import numpy as np
import viser

from ..arrays import Floats
from . import shapes
from .themes import Theme

UPRIGHT = 1e-9
"""A scene lower than this part of its width is one of the plane."""


class Stage:
    """The surroundings of one server's scene."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        server.scene.set_up_direction("+z")
        server.scene.configure_default_lights(cast_shadow=False)

    def dress(self, theme: Theme) -> None:
        """The colours of the browser's own parts and of the background."""
        self._server.gui.configure_theme(
            dark_mode=theme.dark, brand_color=theme.rgb("accent"), show_share_button=False, show_logo=False
        )
        self._server.scene.set_background_image(np.full((2, 2, 3), theme.rgb("scene"), dtype=np.uint8), format="png")

    def frame(self, outline: Floats, theme: Theme, *, camera: bool = True) -> None:
        """Lays the floor and looks at the whole outline (P x D, m)."""
        points = shapes.lifted(shapes.known(outline))
        low, high = points.min(axis=0), points.max(axis=0)
        centre, size = (low + high) / 2, float(np.linalg.norm(high - low)) or 1.0
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
            position=(centre[0], centre[1], min(0.0, low[2])),
        )
        if not camera:
            return
        flat = high[2] - low[2] <= UPRIGHT * size
        away = np.array([0.0, -0.15, 1.0]) if flat else np.array([0.25, -1.0, 0.75])
        place = centre + 0.85 * size * away / np.linalg.norm(away)
        initial = self._server.initial_camera
        initial.look_at, initial.position, initial.up = tuple(centre), tuple(place), (0.0, 0.0, 1.0)
        initial.near, initial.far = 1e-3 * size, 1e2 * size
        for client in self._server.get_clients().values():
            with client.atomic():
                client.camera.up_direction, client.camera.position = (0.0, 0.0, 1.0), place
                client.camera.look_at = centre
                client.camera.near, client.camera.far = initial.near, initial.far
