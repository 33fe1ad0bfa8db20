"""A bound over a plane."""

from dataclasses import dataclass

import numpy as np

from .arrays import Floats


@dataclass(frozen=True)
class Field:
    """The bound at the centre of each cell of a grid.

    `values` are rows x columns, m or rad as the scenario's `field.quantity` says, NaN where there is no bound; `edges`
    are 3 x 3, m: the outer corner of the first cell, the edge along a row, the edge from row to row.
    """

    values: Floats
    edges: Floats

    @property
    def points(self) -> Floats:
        """The centres of the cells in the world frame, m: rows x columns x 3."""
        rows, columns = self.values.shape
        corner, along, across = self.edges
        u = (np.arange(columns) + 0.5) / columns
        v = (np.arange(rows) + 0.5) / rows
        return np.asarray(corner + v[:, None, None] * across + u[None, :, None] * along)
