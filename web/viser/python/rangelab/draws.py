"""Anchors fixed against anchors redrawn."""

from dataclasses import dataclass

import numpy as np

from . import _core
from .arrays import Floats
from .jobs import Progress, run_jobs

OF = {"posterior_crb": 1, "kf": 3, "uc-kf": 5}
"""Where the numbers of each bound or estimator begin in a draw."""


@dataclass(frozen=True)
class AnchorDraws:
    """Trials with the scenario's own anchors, and the same trials with anchors drawn anew; n counts draws."""

    numbers: Floats
    """Fixed, redrawn; the condition, then angle (rad) and position (m) of the bound, KF and UC-KF: n x 2 x 7."""
    half_width: float
    """Half the width of the cube around the origin in which anchors are drawn, m."""

    @property
    def conditions(self) -> Floats:
        """Largest over least singular value of the whitened anchors, fixed and redrawn: n x 2; NaN in one plane."""
        return self.numbers[:, :, 0]

    def angles(self, of: str) -> Floats:
        """Root mean square angle of `"posterior_crb"`, `"kf"` or `"uc-kf"`, rad: n x 2, NaN where there is none."""
        return self.numbers[:, :, _place(of)]

    def positions(self, of: str) -> Floats:
        """Root mean square error of the position in the same way, m: n x 2."""
        return self.numbers[:, :, _place(of) + 1]


def _place(of: str) -> int:
    if of not in OF:
        raise _core.UnknownName(f'no part of the draws is called "{of}"; there are: {", ".join(OF)}')
    return OF[of]


def anchor_draws(scenario: _core.Scenario, draws: int, threads: int | None, progress: Progress | None) -> AnchorDraws:
    """Draws on threads, in their order."""
    study = _core.AnchorDraws(scenario, draws)
    parts: list[Floats] = []

    def told(_: int) -> bool | None:
        return progress(sum(map(len, parts)), draws) if progress else None

    run_jobs(study.jobs, study.job, parts.append, threads=threads, progress=told)
    return AnchorDraws(np.concatenate(parts), study.half_width)
