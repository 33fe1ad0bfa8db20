"""What a run of indoor filters shows, or averages with how sure they are, in up to three sentences."""

import numpy as np

from ...indoor import IndoorRun
from ..looks import FILTERS
from ..readout import reading
from .averages import Averages
from .findings import Finding, first_stopped, weightiest
from .indoor_lessons import lessons
from .indoor_levels import levels_of_averages, levels_of_run


def described(run: IndoorRun, convention: str) -> str:
    """Of one run: first the filter that stopped first, and why."""
    levels = levels_of_run(run)
    first = first_stopped((*each.failure, each.label) for each in run.filters.values() if each.failure)
    return first.text if first and not levels else weightiest([first, *lessons(levels, convention)])


def judged(averages: Averages, filters: list[str], convention: str) -> str:
    """Of many trials."""
    summaries = {name: averages.summary(name) for name in filters}
    failures = [
        Finding(f"{FILTERS[name].label} stopped in {found['failures']} of {averages.trials} trials.", 100)
        for name, found in summaries.items()
        if found["failures"]
    ]
    positions = [found["position"] for found in summaries.values() if found["trials"]]
    shares = [each["standard_error"] / each["value"] for each in positions if each["standard_error"] is not None]
    worst = max((share for share in shares if np.isfinite(share)), default=0.0)
    sure = Finding(f"Mean over {averages.trials} trials, ±{reading(100 * worst)} % at most.", 95)
    return weightiest([*failures, sure, *lessons(levels_of_averages(averages, filters), convention)])
