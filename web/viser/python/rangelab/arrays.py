"""The types of arrays."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
"""Doubles."""
Flags = NDArray[np.bool_]
"""Truth values."""
Part = tuple[str, str, int | None, str | None]
"""Name, label, the step at which it stopped, why."""
TrackArrays = tuple[Floats, Floats, Floats, Floats, Floats, Flags, tuple[int, str] | None]
"""The parts of a `Track`, in their order."""
