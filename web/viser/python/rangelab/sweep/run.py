"""A sweep from grid to table."""

from collections.abc import Iterable
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

from .._core import Cancelled
from ..documents import plain
from ..families import AnyScenario
from ..frames import Row, rows_of_report
from ..jobs import Progress
from .chunks import Chunk, Grid, Kind, Point, chunks_of, joined, kind_of, points_of
from .engines import Engine, Pending, engine
from .result import Sweep
from .store import Store


def sweep(
    scenario: AnyScenario,
    grid: Grid,
    trials: int = 1000,
    *,
    kind: Kind | None = None,
    on: Any = None,
    folder: str | Path | None = None,
    progress: Progress | None = None,
    trials_per_chunk: int = 100,
) -> Sweep:
    """Runs a study at every point of a grid; the same numbers on any number of workers, wherever they are.

    Args:
        scenario: whose values the grid replaces.
        grid: lists of values by path, as in `{"noise.sigma": [0.01, 0.1], "seed": [1, 2]}`.
        trials: at each point.
        kind: "track" (trackers and bounds step by step) or "localize" for a rigid body, "indoor", or "kinematics" for
            networks of mobile nodes; by default the first that the scenario has.
        on: None (a thread for each processor), how many threads, a `dask.distributed.Client`, "ray", or an executor.
        folder: where done chunks are kept; called again, the sweep goes on from them.
        progress: told how many of how many trials are done; where it returns False the sweep ends with `Cancelled`.
        trials_per_chunk: how many trials a worker is given at a time.

    >>> from rangelab import Scenario
    >>> room = Scenario.preset("room").replace(steps=2)
    >>> sorted({row["noise.sigma"] for row in sweep(room, {"noise.sigma": [0.01, 0.1]}, 20).rows})
    [0.01, 0.1]
    """
    chosen, points = kind_of(scenario, kind), points_of(grid)
    tasks = [_Task.of(scenario, point, chosen, trials, trials_per_chunk) for point in points]
    store, told = Store(folder), Told(progress, trials * len(points))
    with engine(on) as chosen_engine:
        _complete([chunk for task in tasks for chunk in task.chunks], store, chosen_engine, told)
    about = {"version": version("rangelab"), "kind": chosen, "trials": trials, "grid": plain(grid)}
    rows = [row for task in tasks for row in task.rows(store)]
    return Sweep(rows, {**about, "scenario": scenario.to_dict()})


@dataclass(frozen=True)
class _Task:
    """One point of the grid."""

    kind: Kind
    point: Point
    text: str
    trials: int
    chunks: list[Chunk]

    @classmethod
    def of(cls, scenario: AnyScenario, point: Point, kind: Kind, trials: int, size: int) -> "_Task":
        own: AnyScenario = scenario.replace(point)
        return cls(kind, point, own.to_json(), trials, list(chunks_of(kind, own, trials, size)))

    def rows(self, store: Store) -> list[Row]:
        """Its part of the table, once all its chunks are done."""
        numbers = [found for chunk in self.chunks if (found := store.get(chunk)) is not None]
        report = joined(self.kind, self.text, self.trials, numbers)
        return [{**plain(self.point), **row} for row in rows_of_report(report)]


class Told:
    """Counts the trials that are done."""

    def __init__(self, progress: Progress | None, total: int) -> None:
        self._progress, self._total, self._done = progress, total, 0

    def done(self, chunk: Chunk) -> None:
        """Adds the trials of a chunk.

        Raises:
            Cancelled: where that is wished.
        """
        self._done += chunk.last - chunk.jobs.start * chunk.trials_per_job
        if self._progress is not None and self._progress(self._done, self._total) is False:
            raise Cancelled(f"the sweep was called off after {self._done} of {self._total} trials")


def _complete(chunks: Iterable[Chunk], store: Store, on: Engine, told: Told) -> None:
    """Computes the chunks that are not in the store yet."""
    ahead: dict[Pending, Chunk] = {}

    def settle() -> None:
        for future in on.next_done(ahead):
            chunk = ahead.pop(future)
            store.put(chunk, future.result())
            told.done(chunk)

    try:
        for chunk in chunks:
            if store.get(chunk) is not None:
                told.done(chunk)
                continue
            ahead[on.submit(chunk)] = chunk
            if len(ahead) >= on.window:
                settle()
        while ahead:
            settle()
    finally:
        for future in ahead:
            future.cancel()
