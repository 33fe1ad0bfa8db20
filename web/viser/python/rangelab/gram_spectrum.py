"""Eigenvalues of Gram matrices: what classical scaling keeps, and what it leaves as noise."""

import json
from dataclasses import dataclass

import numpy as np

from .arrays import Floats


@dataclass(frozen=True)
class GramSpectrum:
    """The eigenvalues of one trial, decreasing, negative ones too: each N, or empty where there is no such matrix."""

    epoch: Floats
    """Of `-1/2 C D C` of the distances at the complete stamp nearest to time 0, m^2."""
    fitted: Floats
    """Of the fitted `B_0`, from all stamps, m^2."""
    truth: Floats
    """Of the true `Y_0^T Y_0`, m^2."""
    fitted_top: Floats
    """Of the fitted `(L!)^2 B_(2L)`, the Gram matrix of the highest derivative that is assumed, (m/s^L)^2."""
    truth_top: Floats
    """Of the true `Y_L^T Y_L`, (m/s^L)^2."""

    @classmethod
    def from_json(cls, text: str) -> "GramSpectrum":
        """As the crate writes it."""
        return cls(**{name: np.array(values, dtype=np.float64) for name, values in json.loads(text).items()})
