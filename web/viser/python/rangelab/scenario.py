"""Scenarios of the labs Track, Localize and Explore."""

import json
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from .arrays import Floats
from .documents import Document, Written, to_text
from .draws import AnchorDraws, anchor_draws
from .field import Field
from .html import card
from .jobs import Progress
from .recording import Recording
from .run import Run
from .studies import Study, budget_study, localization_study, track_study


def presets() -> list[dict[str, str]]:
    """The scenarios that come with rangelab: `name`, `title` and the one thing each teaches as `summary`."""
    found: list[dict[str, str]] = json.loads(_core.presets())
    return found


def topologies(dimension: int) -> list[dict[str, Any]]:
    """The bodies of a dimension by name: `name`, `title` and `sensors` (N x D, m; the two farthest 1 m apart)."""
    found: list[dict[str, Any]] = json.loads(_core.topologies(dimension))
    return found


class Scenario(Written):
    """A simulated experiment: geometry, noise, motion, and which estimators run on it; immutable.

    `document` is a dictionary or JSON as on the command line and on the page; version, dimension, anchors (M x D, m),
    sensors (N x D, m, body frame) and noise must be given, the rest has defaults.

    Raises:
        InvalidDocument: with every problem, its path, value and limit, in `problems`.
        Error: for text that is no JSON, and for a document of a newer version.

    >>> Scenario({"version": 1, "dimension": 2, "anchors": [[0, 0], [9, 0], [0, 9]],
    ...           "sensors": [[-0.5, 0], [0.5, 0], [0, 1]], "noise": {"kind": "range", "sigma": 0.05}}).steps
    20
    >>> Scenario.preset("room").replace({"noise.sigma": 0.1, "anchors[0]": [0, 0, 1]}, steps=5).steps
    5

    """

    def __init__(self, document: Document | str) -> None:
        self._core = _core.Scenario(to_text(document))

    @classmethod
    def _of(cls, core: _core.Scenario) -> "Scenario":
        scenario = cls.__new__(cls)
        scenario._core = core
        return scenario

    @classmethod
    def preset(cls, name: str = "room") -> "Scenario":
        """A scenario of `rangelab.presets()`."""
        return cls._of(_core.Scenario.preset(name))

    def to_json(self) -> str:
        """The whole scenario as JSON; every number comes back as the same bits."""
        return self._core.to_json()

    @property
    def name(self) -> str:
        """What people call it."""
        return str(self.to_dict()["name"])

    @property
    def dimension(self) -> int:
        """D: 2 in the plane, 3 in space."""
        return int(self.to_dict()["dimension"])

    @property
    def steps(self) -> int:
        """K, how many epochs there are."""
        return int(self.to_dict()["steps"])

    @property
    def anchors(self) -> Floats:
        """Where the anchors stand in the world frame, m: M x D."""
        return np.asarray(self.to_dict()["anchors"], dtype=np.float64)

    @property
    def sensors(self) -> Floats:
        """Where the sensors sit in the body frame, m: N x D."""
        return np.asarray(self.to_dict()["sensors"], dtype=np.float64)

    def simulate(self, trial: int = 0) -> Recording:
        """Draws one trial: the same scenario and trial give the same bits everywhere."""
        return Recording._of(self._core.simulate(trial))

    def run(self, trial: int = 0) -> Run:
        """Simulates one trial and runs the enabled trackers and all bounds on it.

        An estimator that fails says so in its own part of the run (`run["kf"].failure`).
        """
        return Run(self._core.run(trial))

    def localize(self, trial: int = 0) -> dict[str, Any]:
        """What the enabled localizers make of the first epoch of a trial: the crate's `SnapshotRun`.

        `estimators` each have `name`, `label`, `pose` (`orientation` D x D, `position` m), `errors` (rad, m),
        `iterations`, `reflected`, `optimum`, `failure`; `bounds` the least root mean square errors.
        """
        found: dict[str, Any] = json.loads(_core.localize(self._core, trial))
        return found

    def localization_cloud(self, trials: int, first: int = 0) -> Floats:
        """The estimates of many trials as seen from the truth: trials x localizers x (3 + D (D + 1)).

        Along the last axis: 1 where there is a pose, 1 where it mirrors the body, iterations, `Q_hat Q^T` row by row,
        `t_hat - t` (m); zeros where there is no pose.
        """
        return _core.localization_cloud(self._core, first, trials)

    def explore(self) -> dict[str, Any]:
        """What the geometry shows at the pose the body starts from, and what it hides: the crate's `Exploration`.

        `position_sigma` (m) and `angle_sigma` (rad) are the roots of the UC-CRB, `modes` the motions of the body from
        the one seen least, `sentence` says it in words, `twin` is the mirror image with the same ranges.
        """
        found: dict[str, Any] = json.loads(_core.explore(self._core))
        return found

    def bound_at(self, point: ArrayLike) -> dict[str, Any]:
        """The UC-CRB of the body at a point (D, m) with the attitude it starts with; None where there is none."""
        found: dict[str, Any] = json.loads(_core.bound_at(self._core, np.asarray(point, dtype=np.float64)))
        return found

    def field(self, resolution: int = 64) -> Field:
        """The UC-CRB over the plane of the scenario's `field`, `resolution` cells along the longer edge."""
        return Field(*_core.field(self._core, resolution))

    def size_curve(self, scales: ArrayLike) -> Floats:
        """The bound on the orientation (rad) of bodies so many times larger; NaN where there is none."""
        return _core.size_curve(self._core, np.asarray(scales, dtype=np.float64))

    def advise(self) -> dict[str, Any]:
        """What the anchors are worth (`value`, in `unit`) and how that changes with the place of each (`gradient`)."""
        found: dict[str, Any] = json.loads(_core.advise(self._core))
        return found

    def improve(self, restart: int = 0) -> tuple["Scenario", dict[str, Any]]:
        """The scenario with its anchors moved to better places, and `before`, `after`, `unit`, `cause`.

        Restart 0 begins at the anchors as they are, every other anywhere within the limits of `placement`.
        """
        found, scenario = _core.improve(self._core, restart)
        return Scenario._of(scenario), json.loads(found)

    def next_at(self, point: ArrayLike) -> dict[str, Any]:
        """What one more anchor would be worth at a point (D, m): `before`, `after`, `unit`, `cause`."""
        found: dict[str, Any] = json.loads(_core.next_at(self._core, np.asarray(point, dtype=np.float64)))
        return found

    def best_next(self) -> dict[str, Any] | None:
        """Where in the plane of the field one more anchor helps most; None where no place gives a bound."""
        found: dict[str, Any] | None = json.loads(_core.best_next(self._core))
        return found

    def study(self, trials: int = 1000, *, threads: int | None = None, progress: Progress | None = None) -> Study:
        """Monte-Carlo of the enabled trackers and the bounds; the same numbers on any number of threads.

        `progress(done, all)` is called after each 20 trials; where it returns False the study ends with what it has.
        """
        return track_study(self._core, trials, threads, progress)

    def localization_study(
        self,
        noises: Sequence[Document] | None = None,
        trials: int = 1000,
        *,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Study:
        """Monte-Carlo of the enabled localizers at each noise of a sweep; by default at the scenario's own.

        A noise is for example `{"kind": "toa", "zeta_db": 60}`.
        """
        points = [self.to_dict()["noise"]] if noises is None else list(noises)
        return localization_study(self._core, points, trials, threads, progress)

    def budget_study(
        self,
        thresholds: ArrayLike,
        trials: int = 1000,
        *,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Study:
        """What projections of the ET-KF cost and give at these thresholds."""
        return budget_study(self._core, thresholds, trials, threads, progress)

    def anchor_draws(
        self, draws: int = 200, *, threads: int | None = None, progress: Progress | None = None
    ) -> AnchorDraws:
        """Each trial with the scenario's own anchors and with anchors drawn anew, all other random numbers the same."""
        return anchor_draws(self._core, draws, threads, progress)

    def __repr__(self) -> str:
        return f"<rangelab.Scenario {self.name!r}: {self._summary()}>"

    def _summary(self) -> str:
        document = self.to_dict()
        space = "the plane" if document["dimension"] == 2 else "space"
        sizes = f"{len(document['anchors'])} anchors, {len(document['sensors'])} sensors"
        return f"{sizes} in {space}, {document['steps']} epochs"

    def _repr_html_(self) -> str:
        document = self.to_dict()
        rows = {
            "noise": ", ".join(f"{key} {value}" for key, value in document["noise"].items()),
            "trackers": ", ".join(document["estimators"]["enabled"]),
            "seed": str(document["seed"]),
        }
        return card(f"Scenario {self.name}", self._summary(), rows)
