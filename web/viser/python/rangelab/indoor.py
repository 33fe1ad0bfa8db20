"""The Indoor lab: an IMU and three transmitters on a body, beacons in a room."""

import json

from . import _core
from .arrays import Flags, Floats, Part
from .documents import Document, Written, to_text
from .html import card
from .jobs import Progress
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


class IndoorFilterRun:
    """One filter over all samples of the IMU; NaN after a failure."""

    def __init__(self, run: _core.IndoorRun, index: int, part: Part) -> None:
        self._run, self._index = run, index
        self.name, self.label = part[:2]
        self.failure: tuple[int, str] | None = None
        """The step at which it stopped, and why."""
        if part[2] is not None:
            self.failure = (part[2], part[3] or "")

    @property
    def orientations(self) -> Floats:
        """`R` as the filter keeps it, which need not be a rotation: K x 3 x 3."""
        return self._run.orientations(self._index)

    @property
    def positions(self) -> Floats:
        """m: K x 3."""
        return self._run.positions(self._index)

    @property
    def orientation_errors(self) -> Floats:
        """Geodesic angles to the truth, rad: K."""
        return self._run.numbers(self._index, "orientation_error")

    @property
    def position_errors(self) -> Floats:
        """Distances to the truth, m: K."""
        return self._run.numbers(self._index, "position_error")

    @property
    def nees(self) -> Floats:
        """Normalized estimation errors squared over their 9 degrees of freedom: K."""
        return self._run.numbers(self._index, "nees")

    @property
    def nis(self) -> Floats:
        """Normalized innovations squared over their degrees of freedom: K, NaN between fixes."""
        return self._run.numbers(self._index, "nis")


class IndoorRun:
    """One trial through the filters: `run["mekf"]` is one filter."""

    def __init__(self, core: _core.IndoorRun) -> None:
        self._core = core
        self.filters = {part[0]: IndoorFilterRun(core, i, part) for i, part in enumerate(core.filters())}
        """The filters by name."""

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
    def truth_positions(self) -> Floats:
        """m: K x 3."""
        return self._core.truth_positions()

    @property
    def truth_orientations(self) -> Floats:
        """K x 3 x 3."""
        return self._core.truth_orientations()

    def __getitem__(self, name: str) -> IndoorFilterRun:
        try:
            return self.filters[name]
        except KeyError:
            known = ", ".join(self.filters)
            raise _core.UnknownName(f'no filter of this run is called "{name}"; there are: {known}') from None

    def __repr__(self) -> str:
        return f"<rangelab.IndoorRun {self._core.name!r}: {len(self.times)} steps, {', '.join(self.filters)}>"
