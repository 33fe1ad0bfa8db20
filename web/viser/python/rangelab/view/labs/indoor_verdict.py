"""What a run of indoor filters shows, or averages with how sure they are, in up to three sentences."""

import numpy as np

from ...indoor import IndoorRun
from ..looks import FILTERS
from ..readout import reading
from .averages import Averages
from .findings import Finding, as_sentence, count_of, weightiest
from .indoor_lessons import lessons
from .indoor_levels import levels_of_averages, levels_of_run


def described(run: IndoorRun, convention: str) -> str:
    """Of one run: first the filter that stopped first, and why."""
    levels = levels_of_run(run)
    stopped = [(*each.failure, each.label) for each in run.filters.values() if each.failure]
    if not stopped:
        return weightiest(lessons(levels, convention))
    step, why, label = min(stopped, key=lambda each: each[0])
    more = f", and {count_of(len(stopped) - 1)} more" if len(stopped) > 1 else ""
    first = Finding(f"{label} stopped at step {step + 1}{more}: {as_sentence(why)}", 100)
    return weightiest([first, *lessons(levels, convention)]) if levels else first.text


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
