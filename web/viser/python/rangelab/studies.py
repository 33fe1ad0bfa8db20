"""Monte-Carlo studies: averages over many trials, each with its standard error."""

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from .arrays import Floats
from .documents import Document, to_text
from .frames import name_of, rows_of_report
from .html import table
from .jobs import Progress, run_jobs

if TYPE_CHECKING:
    import pandas
    import polars


@dataclass(frozen=True)
class Curve:
    """A figure along the epochs of a run or the points of a sweep, with standard errors; NaN where there is none."""

    values: Floats
    standard_errors: Floats

    @classmethod
    def of(cls, estimates: Iterable[Mapping[str, float | None]], factor: float = 1.0) -> "Curve":
        """From estimates as reports have them, `{"value", "standard_error"}`, so many times as large.

        >>> Curve.of([{"value": 2.0, "standard_error": 0.5}, {"value": None}], 10.0).values
        array([20., nan])

        """
        # As numbers None is NaN.
        rows = [(each.get("value"), each.get("standard_error")) for each in estimates]
        values, errors = factor * np.array(rows, dtype=np.float64).reshape(-1, 2).T
        return cls(values, errors)


@dataclass(frozen=True)
class Study:
    """The report of a study: the document that the command line writes."""

    text: str
    """The report as JSON."""
    asked: int
    """Trials that were asked for; `trials` is smaller where progress said stop."""

    def to_json(self) -> str:
        """The report as JSON, that of the command line."""
        return self.text

    def to_dict(self) -> dict[str, Any]:
        """The report as a dictionary."""
        report: dict[str, Any] = json.loads(self.text)
        return report

    @property
    def trials(self) -> int:
        """Trials that were run."""
        return int(self.to_dict()["trials"])

    @property
    def names(self) -> list[str]:
        """Estimators and bounds with figures."""
        report = self.to_dict()
        parts = [*report.get("estimators", []), *report.get("filters", []), *report.get("bounds", [])]
        return [name_of(part) for part in parts]

    def curve(self, name: str, figure: str) -> Curve:
        """A figure of an estimator or bound, for example `curve("uc-kf", "rmse_position")` (m).

        Raises:
            UnknownName: with the names that exist.

        """
        rows = [row for row in self.rows() if row["name"] == name]
        if not rows:
            raise _core.UnknownName(f'no part of this study is called "{name}"; there are: {", ".join(self.names)}')
        known = ", ".join(dict.fromkeys(key for row in rows for key in row if f"{key}_standard_error" in row))
        rows = [row for row in rows if figure in row]
        if not rows:
            raise _core.UnknownName(f'no figure of {name} is called "{figure}"; there are: {known}')

        def column(key: str) -> Floats:
            return np.asarray([row.get(key, np.nan) for row in rows], dtype=np.float64)

        return Curve(column(figure), column(f"{figure}_standard_error"))

    def rows(self) -> list[dict[str, Any]]:
        """The report as a table: a row for each estimator or bound and epoch or point."""
        return rows_of_report(self.to_dict())

    def to_pandas(self) -> "pandas.DataFrame":
        """The table as a pandas frame (extra `frames`)."""
        from .frames import rows_to_pandas

        return rows_to_pandas(self.rows())

    def to_polars(self) -> "polars.DataFrame":
        """The table as a polars frame (extra `frames`)."""
        from .frames import rows_to_polars

        return rows_to_polars(self.rows())

    def __repr__(self) -> str:
        return f"<rangelab.Study {self.to_dict()['name']!r}: {self.trials} trials, {', '.join(self.names)}>"

    def _repr_html_(self) -> str:
        last = {row["name"]: row for row in self.rows()}
        wanted = [
            key
            for key in ("rmse_position", "rms_angle", "position", "angle", "nees")
            if any(key in r for r in last.values())
        ]
        rows = [[name, *(_with_error(row, key) for key in wanted)] for name, row in last.items()]
        title = f"Study of {self.to_dict()['name']}: {self.trials} trials, last epoch or point"
        return table(title, ["", *wanted], rows)


def _with_error(row: dict[str, Any], key: str) -> str:
    value, error = row.get(key), row.get(f"{key}_standard_error")
    if value is None or error is None or np.isnan(value):
        return ""
    return f"{value:.4g} ± {error:.1g}"


def run_plan(plan: _core.Plan, trials: int, threads: int | None, progress: Progress | None) -> Study:
    """Runs the jobs of a plan on threads."""
    total = plan.start()

    def told(joined: int) -> bool | None:
        return progress(min(trials, joined * plan.trials_per_job), trials) if progress else None

    run_jobs(plan.jobs, plan.job, total.push, threads=threads, progress=told)
    return Study(total.report(), trials)


def track_study(scenario: _core.Scenario, trials: int, threads: int | None, progress: Progress | None) -> Study:
    """Trackers and bounds."""
    return run_plan(_core.Plan.track(scenario, trials), trials, threads, progress)


def localization_study(
    scenario: _core.Scenario,
    noises: Sequence[Document],
    trials: int,
    threads: int | None,
    progress: Progress | None,
) -> Study:
    """Localizers at each noise."""
    points = json.dumps([json.loads(to_text(noise)) for noise in noises])
    return run_plan(_core.Plan.localize(scenario, points, trials), trials, threads, progress)


def budget_study(
    scenario: _core.Scenario,
    thresholds: ArrayLike,
    trials: int,
    threads: int | None,
    progress: Progress | None,
) -> Study:
    """The ET-KF at each threshold."""
    numbers = np.asarray(thresholds, dtype=np.float64).reshape(-1)
    return run_plan(_core.Plan.budget(scenario, numbers, trials), trials, threads, progress)


def indoor_study(scenario: _core.IndoorScenario, trials: int, threads: int | None, progress: Progress | None) -> Study:
    """The filters of an indoor scenario."""
    return run_plan(_core.Plan.indoor(scenario, trials), trials, threads, progress)


def kinematics_study(
    scenario: _core.KinematicsScenario, trials: int, threads: int | None, progress: Progress | None
) -> Study:
    """Relative kinematics of nodes without anchors."""
    return run_plan(_core.Plan.kinematics(scenario, trials), trials, threads, progress)
