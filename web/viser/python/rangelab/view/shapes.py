"""Points, lines and meshes of what is shown: plain arrays, in space; scenes in the plane lie at height 0."""

from functools import cache, lru_cache
from itertools import combinations

import numpy as np

from ..arrays import Floats
from ..consistency import chi_squared_interval
from ..field import Field

Mesh = tuple[Floats, np.ndarray]
"""Vertices (V x 3) and faces (F x 3, whole numbers)."""

FLAT = 1e-6
"""Points nearer to a line than this part of the body are on it."""


def lifted(points: Floats) -> Floats:
    """Points of the plane or of space as points of space."""
    flat = np.zeros((*points.shape[:-1], 3))
    flat[..., : points.shape[-1]] = points
    return flat


def known(points: Floats) -> Floats:
    """Those of some points (P x D) that have all their coordinates."""
    return points[np.isfinite(points).all(axis=1)]


def magnified(positions: Floats, truth: Floats, times: float) -> Floats:
    """Estimates with their errors so many times as large; as they are where the truth is not known."""
    return np.where(np.isfinite(truth), truth + times * (positions - truth), positions)


def path(points: Floats) -> Floats:
    """The segments of a path (S x 2 x 3), without those that a missing point would have."""
    points = lifted(points)
    segments = np.stack([points[:-1], points[1:]], axis=1)
    return segments[np.isfinite(segments).all(axis=(1, 2))]


def pairs(points: Floats) -> Floats:
    """The segments between all pairs of points."""
    i, j = np.triu_indices(len(points), 1)
    return np.stack([points[i], points[j]], axis=1)


def frame(body: Floats, places: Floats) -> Floats:
    """The edges of a body's hull (S x 2 x 3): its points in its own frame (N x D), and where they are (N x D)."""
    edges = hull_edges(tuple(map(tuple, lifted(body).tolist())))
    return lifted(places)[edges] if len(edges) else np.zeros((0, 2, 3))


@lru_cache(64)
def hull_edges(body: tuple[tuple[float, float, float], ...]) -> np.ndarray:
    """Which points of a body are joined by an edge of its convex hull: E x 2; of a rod its ends.

    Seen along an edge, both its ends are one corner of the shadow of the body.
    """
    points = np.array(body)
    size = float(np.linalg.norm(points - points.mean(axis=0), axis=1).max())
    found = [pair for pair in combinations(range(len(points)), 2) if _is_edge(points, *pair, size)]
    return np.array(found, dtype=int).reshape(-1, 2)


def _is_edge(points: Floats, i: int, j: int, size: float) -> bool:
    along = points[j] - points[i]
    length = float(np.linalg.norm(along))
    if length < FLAT * size:
        return False
    ways = points - points[i]
    shares = ways @ along / length**2
    shadow = ways - shares[:, None] * along
    aside = np.linalg.norm(shadow, axis=1) > FLAT * size
    if (shares[~aside] < -FLAT).any() or (shares[~aside] > 1 + FLAT).any():
        return False
    if not aside.any():
        return True
    first = shadow[aside][0] / np.linalg.norm(shadow[aside][0])
    second = np.cross(along / length, first)
    angles = np.sort(np.arctan2(shadow[aside] @ second, shadow[aside] @ first))
    # A corner: all others are within less than half a turn.
    gaps = np.diff(np.append(angles, angles[0] + 2 * np.pi))
    return bool(gaps.max() > np.pi + FLAT)


def between(origins: Floats, ends: Floats, present: np.ndarray) -> Floats:
    """The segments from each of the first to each of the second points (M x N) that are present."""
    m, n = np.nonzero(present)
    return np.stack([lifted(origins)[m], lifted(ends)[n]], axis=1)


def body(orientation: Floats, position: Floats, sensors: Floats) -> Floats:
    """The sensors in the world frame: N x D."""
    return np.asarray(sensors @ orientation.T + position)


def sphere(rings: int = 10, sectors: int = 18) -> Mesh:
    """A unit sphere."""
    polar = np.linspace(0, np.pi, rings + 1)
    around = np.linspace(0, 2 * np.pi, sectors, endpoint=False)
    a, b = np.meshgrid(polar, around, indexing="ij")
    vertices = np.stack([np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), np.cos(a)], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(rings), np.arange(sectors), indexing="ij")
    here, right = i * sectors + j, i * sectors + (j + 1) % sectors
    faces = np.stack([here, here + sectors, right, right, here + sectors, right + sectors], axis=-1)
    return vertices, faces.reshape(-1, 3)


@cache
def radius_95(dimension: int) -> float:
    """How many standard deviations hold 95 % of a normal distribution: the root of the quantile of chi-square."""
    # The interval leaves as much above as below it.
    return float(np.sqrt(chi_squared_interval(dimension, 0.9)[1]))


def ellipsoid(covariance: Floats, centre: Floats, magnify: float) -> Mesh:
    """The surface about a centre that holds 95 % of the places, so many times as large; flat in the plane."""
    d = covariance.shape[0]
    values, vectors = np.linalg.eigh(covariance)
    root = np.zeros((3, 3))
    root[:d, :d] = vectors * np.sqrt(np.maximum(values, 0.0))
    vertices, faces = sphere()
    return magnify * radius_95(d) * vertices @ root.T + lifted(centre), faces


def field_mesh(field: Field) -> tuple[Floats, np.ndarray, Floats]:
    """The rectangle of a field: vertices, faces, and for each vertex the place on the picture (0 to 1, from below).

    It ends at the centres of the outer cells: beyond the picture's edge the picture would begin anew.
    """
    cells = np.array(field.values.shape[::-1], dtype=np.float64)
    corners = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    places = (corners * (cells - 1) + 0.5) / cells
    return on_field(field, places), np.array([[0, 1, 2], [0, 2, 3]]), places


def on_field(field: Field, places: Floats) -> Floats:
    """Places on the picture of a field (P x 2, 0 to 1) in the world, m: P x 3."""
    corner, along, across = field.edges
    return np.asarray(corner + places[:, :1] * along + places[:, 1:] * across)


def hit(field: Field, origin: Floats, direction: Floats) -> Floats | None:
    """Where a ray meets the rectangle of a field, m: 3; None beside it and where it is seen edge-on."""
    corner, along, across = field.edges
    columns = np.stack([along, across, -direction], axis=1)
    if abs(np.linalg.det(columns)) < 1e-12 * np.prod(np.linalg.norm(columns, axis=0)):
        return None
    u, v, way = np.linalg.solve(columns, origin - corner)
    return np.asarray(origin + way * direction) if way > 0 and 0 <= u <= 1 and 0 <= v <= 1 else None


def quaternion(rotation: Floats) -> Floats:
    """(w, x, y, z) of a rotation; one in the plane turns about the vertical."""
    full = np.eye(3)
    full[: rotation.shape[0], : rotation.shape[1]] = rotation
    # The column of largest length of q q^T (Shepperd's method): no difference of nearly equal numbers.
    m, t = full, np.trace(full)
    square = 0.25 * np.array(
        [
            [1 + t, m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]],
            [m[2, 1] - m[1, 2], 1 + 2 * m[0, 0] - t, m[0, 1] + m[1, 0], m[0, 2] + m[2, 0]],
            [m[0, 2] - m[2, 0], m[0, 1] + m[1, 0], 1 + 2 * m[1, 1] - t, m[1, 2] + m[2, 1]],
            [m[1, 0] - m[0, 1], m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], 1 + 2 * m[2, 2] - t],
        ]
    )
    column = square[:, int(np.argmax(np.diag(square)))]
    return np.asarray(column / np.linalg.norm(column))


def rotation(wxyz: Floats, dimension: int) -> Floats:
    """The rotation of a quaternion; in the plane its part about the vertical."""
    w, x, y, z = np.asarray(wxyz, dtype=np.float64) / np.linalg.norm(wxyz)
    if dimension == 2:
        length = np.hypot(w, z) or 1.0
        c, s = (w * w - z * z) / length**2, 2 * w * z / length**2
        return np.array([[c, -s], [s, c]])
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def dashed(segments: Floats, on: int = 2, off: int = 1) -> Floats:
    """Some of the segments, some left out, again and again."""
    return segments[np.arange(len(segments)) % (on + off) < on]


def box(low: Floats, high: Floats, *, flat: bool) -> tuple[Floats, np.ndarray, np.ndarray]:
    """The box between two corners (3, m): vertices (V x 3), faces (F x 3) and edges (E x 2); flat, its floor alone."""
    ring = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    floor = np.where(np.c_[ring, np.zeros(4, int)] == 1, high, low)
    around = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])
    level = np.array([[0, 1, 2], [0, 2, 3]])
    if flat:
        return floor, level, around
    roof = floor.copy()
    roof[:, 2] = high[2]
    sides = [[[i, j, j + 4], [i, j + 4, i + 4]] for i, j in around]
    faces = np.concatenate([level, level + 4, np.array(sides).reshape(-1, 3)])
    return (
        np.concatenate([floor, roof]),
        faces,
        np.concatenate([around, around + 4, np.c_[np.arange(4), np.arange(4) + 4]]),
    )


def divided(segments: Floats, parts: int) -> Floats:
    """Each segment (S x 2 x 3) in so many equal parts."""
    shares = np.linspace(0.0, 1.0, parts + 1)[:, None]
    points = segments[:, :1] * (1 - shares) + segments[:, 1:] * shares
    return np.stack([points[:, :-1], points[:, 1:]], axis=2).reshape(-1, 2, 3)
