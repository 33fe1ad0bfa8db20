"""Fans around an axis: directions that hold 95 % of where it points."""

import numpy as np

from ..arrays import Floats
from .shapes import radius_95

WIDEST = np.pi / 2
"""Beyond a right angle nothing is known of a direction."""
CORNERS = 28


def fan_around(axis: Floats, covariance: Floats) -> Floats:
    """Unit directions (P x 3) around a unit axis (3); none where the covariance says nothing.

    The tip of the axis moves by `w x axis` for a small rotation vector `w`, whose covariance (world frame, rad^2) is
    3 x 3: a closed ring; or 1 x 1 about z in the plane: an arc.
    """
    if not np.isfinite(covariance).all():
        return np.zeros((0, 3))
    if len(covariance) == 1:
        half = radius_95(1) * np.sqrt(covariance[0, 0])
        tangents = np.linspace(-half, half, CORNERS // 2 + 1)[:, None] * np.cross([0.0, 0.0, 1.0], axis)
    else:
        other = [0.0, 0.0, 1.0] if abs(axis[2]) < 0.8 else [1.0, 0.0, 0.0]
        first = np.cross(axis, other)
        first /= np.linalg.norm(first)
        basis = np.array([first, np.cross(axis, first)])
        # Of the tip along a tangent: (w x axis) . tangent = w . (axis x tangent).
        across = np.cross(axis, basis)
        values, vectors = np.linalg.eigh(across @ covariance @ across.T)
        turns = np.linspace(0.0, 2 * np.pi, CORNERS + 1)
        circle = np.stack([np.cos(turns), np.sin(turns)], axis=1)
        tangents = radius_95(2) * circle * np.sqrt(np.maximum(values, 0.0)) @ vectors.T @ basis
    lengths = np.linalg.norm(tangents, axis=1, keepdims=True)
    angles = np.minimum(WIDEST, lengths)
    sides = np.divide(tangents, lengths, out=np.zeros_like(tangents), where=lengths > 0)
    return np.asarray(np.cos(angles) * axis + np.sin(angles) * sides)
