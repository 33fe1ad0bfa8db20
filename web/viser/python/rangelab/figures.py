"""The papers' figures: computed here, with what holds of their claims."""

import json
from dataclasses import dataclass
from typing import Any

from . import _core
from .html import table
from .jobs import Progress, run_jobs


def figures() -> list[dict[str, Any]]:
    """The figures there are: `name`, `paper`, `number`, `title`, `statement`, `trials`."""
    found: list[dict[str, Any]] = json.loads(_core.figures())
    return found


@dataclass(frozen=True)
class Figure:
    """A computed figure: the files of `rangelab figure`, bit for bit."""

    text: str
    """The report as JSON: `panels` of `curves`, and `claims` with what was found and a `verdict`."""
    csv: str
    """Its curves as comma-separated values."""

    def to_json(self) -> str:
        """The report as JSON."""
        return self.text

    def to_dict(self) -> dict[str, Any]:
        """The report as a dictionary."""
        report: dict[str, Any] = json.loads(self.text)
        return report

    @property
    def claims(self) -> list[dict[str, Any]]:
        """What is claimed, what was found, and the verdict."""
        found: list[dict[str, Any]] = self.to_dict()["claims"]
        return found

    def __repr__(self) -> str:
        report = self.to_dict()
        return f"<rangelab.Figure {report['name']}: {report['trials']} trials, {len(self.claims)} claims>"

    def _repr_html_(self) -> str:
        report = self.to_dict()
        rows = [[str(claim.get("what")), str(claim.get("verdict"))] for claim in self.claims]
        return table(f"{report['title']} ({report['trials']} trials)", ["claim", "verdict"], rows)


def figure(
    name: str,
    trials: int | None = None,
    seed: int = 1,
    *,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Figure:
    """Computes a figure; by default with the paper's number of trials.

    `progress(done, all)` counts jobs; where it returns False the figure is that of the jobs so far.

    Raises:
        UnknownName: with the names that exist.

    """
    known = {each["name"]: each for each in figures()}
    plan = _core.FigurePlan(name, trials or int(known.get(name, {}).get("trials", 1)), seed)

    def told(joined: int) -> bool | None:
        return progress(joined, plan.jobs) if progress else None

    run_jobs(plan.jobs, plan.job, plan.push, threads=threads, progress=told)
    return Figure(*plan.report())
