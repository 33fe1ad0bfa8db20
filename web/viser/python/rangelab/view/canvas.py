"""A drawing in the scene, part by part: what stays the same is sent once, what is not drawn again goes."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Literal

import numpy as np
import trimesh
import viser
from PIL import Image

from ..arrays import Floats
from ..field import Field
from . import shapes
from .colours import field_colours, fine_logs, hatched, lined
from .contours import Levels, crossings, label_places
from .looks import Look
from .themes import Theme
from .values import in_order

POINT_SHAPES: dict[str, Literal["circle", "square", "diamond", "rounded", "sparkle"]] = {
    "disc": "circle",
    "ring": "circle",
    "square": "square",
    "diamond": "diamond",
    "triangle": "rounded",
    "cross": "sparkle",
}
"""The nearest that viser has to the page's marks."""
Pressed = Callable[[Floats], None]
"""Told the place (3, m) of a press."""
MARK = 0.008
"""Size of a mark beside the scene."""
OPACITY = 0.75
"""Of a field; the page's are a little lower, on a renderer that blends in another way."""


class Canvas:
    """The drawn part of one server's scene."""

    def __init__(self, server: viser.ViserServer, theme: Theme, pressed: Pressed) -> None:
        self._server, self.theme, self.pressed = server, theme, pressed
        self._parts: dict[str, tuple[viser.SceneNodeHandle, tuple[Any, ...]]] = {}
        self._seen: set[str] = set()
        self.unit = 1.0
        """How large the scene is, m."""
        self.ellipsoids = False
        """Whether there are ellipsoids, which have to be explained."""

    @contextmanager
    def drawing(self) -> Iterator[None]:
        """What is drawn within is all there is; browsers show it at once."""
        with self._server.atomic():
            self._seen, self.ellipsoids = set(), False
            yield
            for name in self._parts.keys() - self._seen:
                self._parts.pop(name)[0].remove()

    def clear(self) -> None:
        """Takes all away, as another theme asks for."""
        with self.drawing():
            pass

    def lines(self, name: str, segments: Floats, token: str, width: float = 1.0) -> None:
        """Segments (S x 2 x 3, m), so many pixels wide."""
        if not len(segments):
            return
        points, colour = segments.astype(np.float32), self.theme.rgb(token)
        thickness = width * self.theme.weight
        self._put(
            name,
            (points, colour, thickness),
            lambda: self._server.scene.add_line_segments(
                name, points, colour, thickness=thickness, thickness_units="screen"
            ),
        )

    def marks(self, name: str, places: Floats, look: Look, size: float = 1.0) -> None:
        """The mark of an estimator at each of some places (P x 3, m)."""
        points = shapes.known(places).astype(np.float32)
        if not len(points):
            return
        colour, shape = self.theme.rgb(look.token), POINT_SHAPES[look.mark]
        world = MARK * size * np.sqrt(self.theme.weight) * self.unit
        self._put(
            name,
            (points, colour, shape, world),
            lambda: self._server.scene.add_point_cloud(name, points, colour, point_size=world, point_shape=shape),
        )

    def ellipsoid(self, name: str, covariance: Floats, centre: Floats, magnify: float, token: str) -> None:
        """What holds 95 % of the places, so many times as large; nothing where the covariance is not known."""
        if np.isfinite(covariance).all() and np.isfinite(centre).all():
            self.ellipsoids = True
            self.faces(name, *shapes.ellipsoid(covariance, centre, magnify), token, 0.25)

    def faces(self, name: str, vertices: Floats, triangles: np.ndarray, token: str, opacity: float) -> None:
        """A surface that one sees through."""
        points, colour = vertices.astype(np.float32), self.theme.rgb(token)
        self._put(
            name,
            (points, triangles, colour, opacity),
            lambda: self._server.scene.add_mesh_simple(
                name, points, triangles, color=colour, opacity=opacity, side="double", cast_shadow=False
            ),
        )

    def label(self, name: str, text: str, place: Floats, *, centred: bool = False) -> None:
        """A word below and to the right of a place (3, m), or on it."""
        scale = self.theme.letters
        self._put(
            name,
            (text, place, scale),
            lambda: self._server.scene.add_label(
                name,
                text,
                position=place,
                font_screen_scale=scale,
                anchor="center-center" if centred else "top-left",
            ),
        )

    def field(self, name: str, field: Field, limit: float | None, levels: Levels | None = None) -> None:
        """A bound over a plane, hatched above a limit, with lines of round values; a press reads it."""
        levels = Levels((), "", 1.0) if levels is None else levels
        crossed = crossings(fine_logs(field.values), levels)

        def made() -> viser.SceneNodeHandle:
            colours = hatched(field_colours(field.values, self.theme), field.values, limit, self.theme)
            node = self._server.scene.add_mesh_trimesh(
                name,
                _glowing(field, lined(colours, crossed > 0, self.theme)),
                cast_shadow=False,
                receive_shadow=False,
            )

            @node.on_click
            async def _(event: viser.SceneNodePointerEvent[Any]) -> None:
                place = shapes.hit(field, np.array(event.ray_origin), np.array(event.ray_direction))
                if place is not None:
                    in_order(self.pressed, place)

            return node

        self._put(name, (field.values, field.edges, limit, levels, self.theme.css("no-bound")), made)
        for i, (text, u, v) in enumerate(label_places(crossed, levels)):
            self.label(f"{name}-level-{i}", text, shapes.on_field(field, np.array([[u, v]]))[0], centred=True)

    def _put(self, name: str, what: tuple[Any, ...], make: Callable[[], viser.SceneNodeHandle]) -> None:
        self._seen.add(name)
        known = self._parts.get(name)
        if known is None or not all(np.array_equal(a, b) for a, b in zip(known[1], what, strict=True)):
            self._parts[name] = (make(), what)


def _glowing(field: Field, colours: Floats) -> trimesh.Trimesh:
    """The field as a mesh that shines by itself: light would change its colours."""
    vertices, faces, places = shapes.field_mesh(field)
    # Rows of a picture go down.
    picture = Image.fromarray(colours[::-1].round().astype(np.uint8))
    material = trimesh.visual.material.PBRMaterial(  # type: ignore[no-untyped-call]
        baseColorFactor=(0, 0, 0, round(255 * OPACITY)),
        alphaMode="BLEND",
        emissiveTexture=picture,
        emissiveFactor=(1.0, 1.0, 1.0),
        doubleSided=True,
        roughnessFactor=1.0,
        metallicFactor=0.0,
    )
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    mesh.visual = trimesh.visual.TextureVisuals(uv=places, material=material)  # type: ignore[no-untyped-call]
    return mesh
