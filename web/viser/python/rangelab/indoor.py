"""The Indoor lab: an IMU and three transmitters on a body, beacons in a room."""

import json
from collections.abc import Callable

import numpy as np

from . import _core
from .arrays import Flags, Floats
from .documents import Document, Written, to_text
from .frames import Row
from .html import card, table
from .jobs import Progress
from .reports import PosePart, RunReport
from .studies import Study, indoor_study


def indoor_presets() -> list[dict[str, str]]:
    """The indoor scenarios that come with rangelab: `name`, `title`, `summary`."""
    found: list[dict[str, str]] = json.loads(_core.indoor_presets())
    return found


class IndoorScenario(Written):
    """A simulated indoor experiment in space; immutable. Only the version must be given.

    Raises:
        InvalidDocument: with every problem, its path, value and limit, in `problems`.

    """

    def __init__(self, document: Document | str) -> None:
        self._core = _core.IndoorScenario(to_text(document))

    @classmethod
    def preset(cls, name: str = "indoor-u") -> "IndoorScenario":
        """A scenario of `rangelab.indoor_presets()`."""
        return cls(_core.IndoorScenario.preset(name).to_json())

    def to_json(self) -> str:
        """The whole scenario as JSON; every number comes back as the same bits."""
        return self._core.to_json()

    def run(self, trial: int = 0) -> "IndoorRun":
        """Simulates one trial and runs the enabled filters; one that fails says so in its own part."""
        return IndoorRun(self._core.run(trial))

    def study(self, trials: int = 1000, *, threads: int | None = None, progress: Progress | None = None) -> Study:
        """Monte-Carlo of the enabled filters, as `Scenario.study`."""
        return indoor_study(self._core, trials, threads, progress)

    def __repr__(self) -> str:
        document = self.to_dict()
        return f"<rangelab.IndoorScenario {document['name']!r}: {len(document['beacons'])} beacons>"

    def _repr_html_(self) -> str:
        document = self.to_dict()
        rows = {"path": str(document["path"]), "filters": ", ".join(document["filters"]["enabled"])}
        return card(f"Indoor scenario {document['name']}", f"{len(document['beacons'])} beacons", rows)


class IndoorFilterRun(PosePart[_core.IndoorRun]):
    """One filter over all samples of the IMU; NaN after a failure."""

    @property
    def orientations(self) -> Floats:
        """`R` as the filter keeps it, which need not be a rotation: K x 3 x 3."""
        return self._run.orientations(self._index)

    @property
    def positions(self) -> Floats:
        """m: K x 3."""
        return self._run.positions(self._index)

    @property
    def singular_values(self) -> Floats:
        """Of `R`, decreasing, all 1 for a rotation: K x 3."""
        return self._run.singular_values(self._index)

    @property
    def nees(self) -> Floats:
        """Normalized estimation errors squared over their 9 degrees of freedom: K."""
        return self.numbers("nees")

    @property
    def nis(self) -> Floats:
        """Normalized innovations squared over their degrees of freedom: K, NaN between fixes."""
        return self.numbers("nis")


class IndoorRun(RunReport[IndoorFilterRun]):
    """One trial through the filters: `run["mekf"]` is one filter."""

    _what = "filter"

    def __init__(self, core: _core.IndoorRun) -> None:
        self._core = core
        self.filters = {part[0]: IndoorFilterRun(core, i, part) for i, part in enumerate(core.filters())}
        """The filters by name."""
        super().__init__(self.filters)

    @property
    def name(self) -> str:
        """Name of the scenario."""
        return self._core.name

    def rows(self) -> list[Row]:
        """A row for each filter and step; NIS between fixes is NaN."""
        columns: dict[str, Callable[[IndoorFilterRun], Floats]] = {
            "position_error_m": lambda each: each.position_errors,
            "orientation_error_rad": lambda each: each.orientation_errors,
            "nees": lambda each: each.nees,
            "nis": lambda each: each.nis,
        }
        rows: list[Row] = []
        for each in self.filters.values():
            numbers = {key: of(each).tolist() for key, of in columns.items()}
            for k, time in enumerate(self.times.tolist()):
                values = {key: column[k] for key, column in numbers.items()}
                rows.append({"name": each.name, "step": k, "time_s": time, **values})
        return rows

    def to_json(self) -> str:
        """The run as JSON."""
        return self._core.to_json()

    @property
    def times(self) -> Floats:
        """Time at the end of each step, s: K."""
        return self._core.times()

    @property
    def fixes(self) -> Flags:
        """Where ranges were taken: K."""
        return self._core.fixes()

    @property
    def beacons(self) -> Floats:
        """World frame, m: M x 3."""
        return self._core.beacons()

    @property
    def transmitters(self) -> Floats:
        """Body frame, m: 3 x 3."""
        return self._core.transmitters()

    @property
    def present(self) -> Flags:
        """Where a range was measured, from each beacon to each transmitter: K x M x 3, false between fixes."""
        return self._core.present()

    @property
    def truth_positions(self) -> Floats:
        """m: K x 3."""
        return self._core.truth_positions()

    @property
    def truth_orientations(self) -> Floats:
        """K x 3 x 3."""
        return self._core.truth_orientations()

    def __repr__(self) -> str:
        return f"<rangelab.IndoorRun {self._core.name!r}: {len(self.times)} steps, {', '.join(self.filters)}>"

    def _repr_html_(self) -> str:
        header = ["", "position error, m (RMS)", "angle, mrad (RMS)", "mean NEES / n", "stopped"]
        rows = []
        for each in self.filters.values():
            errors = (each.position_errors, 1e3 * each.orientation_errors)
            numbers = [f"{np.sqrt(np.nanmean(error**2)):.3g}" for error in errors]
            rows.append([each.label, *numbers, f"{np.nanmean(each.nees):.2f}", each.failure[1] if each.failure else ""])
        return table(f"Run of {self.name}: {len(self.times)} steps", header, rows)
