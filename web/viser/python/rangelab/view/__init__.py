"""The viewer: a scenario or recording in a browser by viser, every edit computed anew by the crate.

`python -m rangelab.view room` opens it; `Viewer` is the same for programs (extra `view`).
"""

from .viewer import Viewer

__all__ = ["Viewer"]
