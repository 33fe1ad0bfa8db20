"""Studies over a grid of parameters: on threads, or unchanged on a cluster of Dask or Ray (extras `dask`, `ray`)."""

from .result import Sweep
from .run import sweep

__all__ = ["Sweep", "sweep"]
