"""Runs: what trackers and bounds made of a recording."""

import json
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from .arrays import Flags, Floats
from .frames import Row, columns_of_csv, csv_to_pandas, csv_to_polars
from .html import table
from .reports import CompiledPart, PosePart, RunReport

if TYPE_CHECKING:
    import pandas
    import polars


class EstimatorRun(PosePart[_core.Run]):
    """One tracker over all epochs; NaN after a failure and where the truth is not known.

    Its `numbers` are, beside the properties, `orientation_error_frobenius`, `nees_degrees_of_freedom`,
    `nis_degrees_of_freedom`, `orientation_covariance_trace` and `position_covariance_trace` (m^2).
    """

    @property
    def orientations(self) -> Floats:
        """`Q` as reported: K x D x D."""
        return self._run.orientations(self._index, "posterior")

    @property
    def positions(self) -> Floats:
        """`t`, m: K x D."""
        return self._run.positions(self._index, "posterior")

    @property
    def prior_orientations(self) -> Floats:
        """`Q` predicted: K x D x D."""
        return self._run.orientations(self._index, "prior")

    @property
    def prior_positions(self) -> Floats:
        """`t` predicted, m: K x D."""
        return self._run.positions(self._index, "prior")

    @property
    def nees(self) -> Floats:
        """Normalized estimation errors squared: K."""
        return self.numbers("nees")

    @property
    def nis(self) -> Floats:
        """Normalized innovations squared: K."""
        return self.numbers("nis")

    @property
    def defects(self) -> Floats:
        """`||Q^T Q - I||_F` before any projection: K."""
        return self.numbers("defect")

    @property
    def events(self) -> Flags:
        """Where `Q` was projected: K."""
        return self._run.events(self._index)


class BoundRun(CompiledPart[_core.Run]):
    """A lower bound on the root mean square error along the track; NaN where it does not exist."""

    @property
    def orientation(self) -> Floats:
        """Least root mean square rotation angle, rad: K."""
        return np.sqrt(self._run.bound_numbers(self._index, "angle_variance"))

    @property
    def position(self) -> Floats:
        """Least root mean square error of the position, m: K."""
        return np.sqrt(self._run.bound_numbers(self._index, "position_trace"))

    @property
    def position_covariances(self) -> Floats:
        """m^2: K x D x D."""
        return self._run.bound_position_covariances(self._index)

    @property
    def rotation_covariances(self) -> Floats:
        """Of the rotation vector of the error in the world frame, rad^2: K x A x A."""
        return self._run.bound_rotation_covariances(self._index)


class Run(RunReport[EstimatorRun]):
    """One recording through trackers and bounds: `run["uc-kf"]` is a tracker, `run.bounds["posterior_crb"]` a bound.

    Its JSON is that of `rangelab run`, bit for bit.
    """

    def __init__(self, core: _core.Run) -> None:
        self._core = core
        self.estimators = {part[0]: EstimatorRun(core, i, part) for i, part in enumerate(core.estimators())}
        """The trackers by name."""
        super().__init__(self.estimators)
        self.bounds = {part[0]: BoundRun(core, i, part) for i, part in enumerate(core.bounds())}
        """The bounds by name; none where the truth is not known."""

    @classmethod
    def from_json(cls, text: str) -> "Run":
        """A run that was written by any door of rangelab."""
        return cls(_core.Run.from_json(text))

    def to_json(self) -> str:
        """The run as JSON; every number comes back as the same bits."""
        return self._core.to_json()

    def to_csv(self) -> str:
        """A row for each tracker and epoch, units in the names of the columns."""
        return self._core.to_csv()

    def rows(self) -> list[Row]:
        """The table of `to_csv`."""
        columns = columns_of_csv(self.to_csv())
        return [dict(zip(columns, cells, strict=True)) for cells in zip(*columns.values(), strict=True)]

    def to_pandas(self) -> "pandas.DataFrame":
        """The table of `to_csv` as a pandas frame (extra `frames`)."""
        return csv_to_pandas(self.to_csv())

    def to_polars(self) -> "polars.DataFrame":
        """The table of `to_csv` as a polars frame (extra `frames`)."""
        return csv_to_polars(self.to_csv())

    @property
    def name(self) -> str:
        """Name of the scenario or recording."""
        return self._core.name

    @property
    def dimension(self) -> int:
        """D: 2 in the plane, 3 in space."""
        return self._core.dimension

    @property
    def times(self) -> Floats:
        """Time of each epoch since the start, s: K."""
        return self._core.times()

    @property
    def anchors(self) -> Floats:
        """The anchors that were used, m: M x D."""
        return self._core.anchors()

    @property
    def sensors(self) -> Floats:
        """Body frame, m: N x D."""
        return self._core.sensors()

    @property
    def present(self) -> Flags:
        """Where a range was measured: K x M x N."""
        return self._core.present()

    @property
    def truth_orientations(self) -> Floats:
        """True orientations: K x D x D, NaN where not known."""
        return self._core.truth_orientations()

    @property
    def truth_positions(self) -> Floats:
        """True positions, m: K x D, NaN where not known."""
        return self._core.truth_positions()

    @cached_property
    def geometry(self) -> dict[str, Any]:
        """How thin `anchors` and `sensors` lie across the `plane` and `line` that fit them best, and what is `unseen`.

        Of each its `thickness` (m) and its `direction`: the plane's normal, along the line.
        """
        found: dict[str, Any] = json.loads(self._core.geometry())
        return found

    @property
    def unseen(self) -> str | None:
        """What all ranges of one epoch cannot tell apart, in a sentence; None where they show the whole pose."""
        return self._core.unseen

    def __reduce__(self) -> tuple[Any, tuple[str]]:
        return Run.from_json, (self.to_json(),)

    def __repr__(self) -> str:
        return f"<rangelab.Run {self.name!r}: {len(self.times)} epochs, {', '.join(self.estimators)}>"

    def _repr_html_(self) -> str:
        header = ["", "position error, mm (last)", "angle, mrad (last)", "mean NEES / n", "stopped"]
        rows = [
            [
                each.label,
                f"{1e3 * each.position_errors[-1]:.3g}",
                f"{1e3 * each.orientation_errors[-1]:.3g}",
                f"{np.mean(each.nees / each.numbers('nees_degrees_of_freedom')):.2f}",
                each.failure[1] if each.failure else "",
            ]
            for each in self.estimators.values()
        ]
        return table(f"Run of {self.name}: {len(self.times)} epochs", header, rows)
