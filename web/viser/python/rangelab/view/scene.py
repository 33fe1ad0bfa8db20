"""What is drawn: anchors with their handles, the body, tracks, ellipsoids and the field."""

from collections.abc import Callable

import numpy as np
import trimesh
import viser
from PIL import Image

from ..arrays import Floats
from ..field import Field
from ..scenario import Scenario
from . import shapes
from .colours import field_colours, rgb
from .state import Shown

Moved = Callable[[int, Floats], None]
"""An anchor, by number, was dragged to a place (D, m)."""
Posed = Callable[[Floats, Floats], None]
"""The body's start was dragged to an orientation (D x D) and a position (D, m)."""


class Scene:
    """The scene of one server."""

    def __init__(self, server: viser.ViserServer, moved: Moved, posed: Posed) -> None:
        self._server, self._moved, self._posed = server, moved, posed
        self._anchors: list[viser.TransformControlsHandle] = []
        self._start: viser.TransformControlsHandle | None = None
        self._dragged: str | None = None
        self._changing: dict[str, viser.SceneNodeHandle] = {}
        server.scene.set_up_direction("+z")
        server.scene.configure_default_lights(cast_shadow=False)

    def draw(self, shown: Shown, step: int, magnify: float) -> None:
        """Draws a run at a step, its errors and ellipsoids (one standard deviation) `magnify` times as large."""
        with self._server.atomic():
            self._handles(shown)
            seen = set(self._changing)
            for name, handle in self._parts(shown, step, magnify):
                self._changing[name] = handle
                seen.discard(name)
            for name in seen:
                self._changing.pop(name).remove()

    def frame(self, shown: Shown) -> None:
        """Lays the grid and looks at the whole scene, once it is opened."""
        points = shapes.lifted(np.concatenate([shown.run.anchors, shown.run.truth_positions]))
        points = points[np.isfinite(points).all(axis=1)]
        low, high = points.min(axis=0), points.max(axis=0)
        centre, size = (low + high) / 2, float(np.linalg.norm(high - low)) or 1.0
        ground = (centre[0], centre[1], min(0.0, low[2]))
        cell = 10.0 ** np.floor(np.log10(size / 3))
        self._server.scene.add_grid(
            "/grid", width=2 * size, height=2 * size, cell_size=cell, section_size=5 * cell, position=ground
        )
        away = np.array([0.25, -1.0, 0.75]) if shown.run.dimension == 3 else np.array([0.0, -0.15, 1.0])
        # The panel covers the right of the window: the scene goes to the left.
        right = np.cross([0.0, 0.0, 1.0], away)
        centre = centre + 0.18 * size * right / np.linalg.norm(right)
        self._server.initial_camera.look_at = tuple(centre)
        self._server.initial_camera.position = tuple(centre + 1.05 * size * away / np.linalg.norm(away))
        self._server.initial_camera.up = (0.0, 0.0, 1.0)

    def _handles(self, shown: Shown) -> None:
        movable = isinstance(shown.wish.source, Scenario)
        anchors = shapes.lifted(shown.run.anchors)
        while len(self._anchors) > len(anchors):
            self._anchors.pop().remove()
        for m, place in enumerate(anchors):
            if m == len(self._anchors):
                self._anchors.append(self._anchor(m, place, shown))
            handle = self._anchors[m]
            handle.visible = True
            if self._dragged != handle.name and not np.array_equal(handle.position, place):
                handle.position = place
        if movable:
            self._start_handle(shown)
        elif self._start is not None:
            self._start.remove()
            self._start = None

    def _anchor(self, m: int, place: Floats, shown: Shown) -> viser.TransformControlsHandle:
        scene, flat = self._server.scene, shown.run.dimension == 2
        size = 0.02 * shown.extent
        handle = scene.add_transform_controls(
            f"/anchors/{m}",
            scale=0.12 * shown.extent,
            disable_rotations=True,
            disable_axes=not isinstance(shown.wish.source, Scenario),
            disable_sliders=not isinstance(shown.wish.source, Scenario),
            active_axes=(True, True, not flat),
            depth_test=False,
            position=place,
        )
        scene.add_box(f"/anchors/{m}/mark", dimensions=(size, size, size), color=rgb("anchor"))
        scene.add_label(f"/anchors/{m}/label", f"A{m + 1}")

        @handle.on_update
        def _(event: viser.TransformControlsEvent) -> None:
            self._dragged = None if event.phase == "end" else handle.name
            self._moved(m, np.asarray(handle.position, dtype=np.float64)[: 2 if flat else 3])

        return handle

    def _start_handle(self, shown: Shown) -> None:
        source = shown.wish.source
        assert isinstance(source, Scenario)
        start, d = source.to_dict()["start"], shown.run.dimension
        orientation, position = np.array(start["orientation"]), np.array(start["position"])
        if self._start is None:
            self._start = self._new_start(shown, d)
        if self._dragged != self._start.name:
            self._start.position = shapes.lifted(position)
            self._start.wxyz = shapes.quaternion(orientation)

    def _new_start(self, shown: Shown, d: int) -> viser.TransformControlsHandle:
        handle = self._server.scene.add_transform_controls(
            "/start", scale=0.1 * shown.extent, active_axes=(True, True, d == 3), depth_test=False
        )
        self._server.scene.add_label("/start/label", "start")

        @handle.on_update
        def _(event: viser.TransformControlsEvent) -> None:
            self._dragged = None if event.phase == "end" else handle.name
            position = np.asarray(handle.position, dtype=np.float64)[:d]
            self._posed(shapes.rotation(np.asarray(handle.wxyz), d), position)

        return handle

    def _parts(self, shown: Shown, step: int, magnify: float) -> list[tuple[str, viser.SceneNodeHandle]]:
        run, parts = shown.run, []
        truth = run.truth_positions
        if np.isfinite(truth).all():
            parts += self._lines("/truth/path", shapes.path(truth), "truth", 4.0)
            sensors = shapes.body(run.truth_orientations[step], truth[step], run.sensors)
            parts += self._lines("/truth/body", shapes.pairs(shapes.lifted(sensors)), "truth", 3.0)
            segments = shapes.between(run.anchors, sensors, run.present[step])
            parts += self._lines("/ranges", segments, "range", 1.0)
        for name, each in run.estimators.items():
            positions = shapes.magnified(each.positions, truth, magnify)
            parts += self._lines(f"/estimators/{name}/path", shapes.path(positions), name, 2.0)
            if np.isfinite(positions[step]).all():
                sensors = shapes.body(each.orientations[step], positions[step], run.sensors)
                parts += self._lines(f"/estimators/{name}/body", shapes.pairs(shapes.lifted(sensors)), name, 2.0)
                parts.append(self._ellipsoid(name, each.position_covariances[step], positions[step], magnify))
        return parts + self._field(shown)

    def _lines(
        self, name: str, segments: Floats, token: str, thickness: float
    ) -> list[tuple[str, viser.SceneNodeHandle]]:
        if not len(segments):
            return []
        scene, points = self._server.scene, segments.astype(np.float32)
        handle = scene.add_line_segments(name, points, rgb(token), thickness=thickness, thickness_units="screen")
        return [(name, handle)]

    def _ellipsoid(
        self, name: str, covariance: Floats, centre: Floats, magnify: float
    ) -> tuple[str, viser.SceneNodeHandle]:
        node = f"/estimators/{name}/ellipsoid"
        vertices, faces = shapes.ellipsoid(covariance, centre, magnify)
        handle = self._server.scene.add_mesh_simple(
            node, vertices.astype(np.float32), faces, color=rgb(name), opacity=0.25, side="double", cast_shadow=False
        )
        return node, handle

    def _field(self, shown: Shown) -> list[tuple[str, viser.SceneNodeHandle]]:
        field = shown.field
        if field is None:
            return []
        handle = self._server.scene.add_mesh_trimesh("/field", _glowing(field), cast_shadow=False, receive_shadow=False)
        return [("/field", handle)]


def _glowing(field: Field) -> trimesh.Trimesh:
    """The field as a mesh that shines by itself: light would change its colours."""
    vertices, faces, places = shapes.field_mesh(field)
    # Rows of a picture go down.
    picture = Image.fromarray(field_colours(field.values)[::-1].round().astype(np.uint8))
    material = trimesh.visual.material.PBRMaterial(  # type: ignore[no-untyped-call]
        baseColorFactor=(0, 0, 0, 255),
        emissiveTexture=picture,
        emissiveFactor=(1.0, 1.0, 1.0),
        doubleSided=True,
        roughnessFactor=1.0,
        metallicFactor=0.0,
    )
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    mesh.visual = trimesh.visual.TextureVisuals(uv=places, material=material)  # type: ignore[no-untyped-call]
    return mesh
