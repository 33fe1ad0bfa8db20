"""One trial of the Anchorless lab through its estimators."""

import json
from typing import Any

import numpy as np

from .arrays import Floats
from .frames import Row
from .html import table
from .reports import RunReport


def _numbers(value: Any) -> Floats:
    return np.asarray(value, dtype=np.float64)


class KinematicsEstimatorRun:
    """What one estimator found, in the frame of the truth; arrays of what it does not give are empty."""

    def __init__(self, part: dict[str, Any], nodes: int, dimension: int) -> None:
        self._part, self._size = part, (nodes, dimension)
        self.name: str = part["name"]
        self.label: str = part["label"]
        self.failure: str | None = part["failure"]
        """Why it gave nothing."""
        self.acceleration_margin: float | None = part["acceleration_margin"]
        """Least eigenvalue kept of the accelerations' Gram matrix over its most negative one; below 1 they drown."""
        self.iterations: int = part["iterations"]
        """0 for closed forms."""

    @property
    def coefficients(self) -> Floats:
        """`Y_0, Y_1, ...` after one alignment in O(D), from `Y_0`, m/s^l: (L + 1) x N x D."""
        return _numbers(self._part["coefficients"]).reshape(-1, *self._size)

    @property
    def coefficient_errors(self) -> Floats:
        """Root mean square error of a coordinate of each, m/s^l: L + 1."""
        return _numbers(self._part["coefficient_errors"])

    @property
    def gram_errors(self) -> Floats:
        """Root mean square error of an entry of `vech(B_0), vech(B_1), vech(B_2)`, m^2/s^l: 3."""
        return _numbers(self._part["gram_errors"])

    @property
    def position_errors(self) -> Floats:
        """Root mean square error of a coordinate at each instant with that alignment, m: T."""
        return _numbers(self._part["position_errors"])

    @property
    def aligned_position_errors(self) -> Floats:
        """The same with an alignment at each instant, m: T."""
        return _numbers(self._part["aligned_position_errors"])

    @property
    def snapshots(self) -> Floats:
        """Positions at each stamp, each aligned by itself, m: K x N x D, NaN where distances are missing."""
        none = np.full(self._size, np.nan)
        found = [none if each is None else each for each in self._part["snapshots"]]
        return _numbers(found).reshape(-1, *self._size)

    def __repr__(self) -> str:
        return f"<rangelab.KinematicsEstimatorRun {self.label}>"


class KinematicsRun(RunReport[KinematicsEstimatorRun]):
    """One trial through the estimators: `run["maximum-likelihood"]` is one of them."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._document: dict[str, Any] = json.loads(text)
        size = self.truth.shape[1:]
        parts = (KinematicsEstimatorRun(part, *size) for part in self._document["estimators"])
        self.estimators = {part.name: part for part in parts}
        """The estimators by name."""
        super().__init__(self.estimators)

    @property
    def name(self) -> str:
        """Name of the scenario."""
        return str(self._document["name"])

    def to_json(self) -> str:
        """The run as JSON; every number comes back as the same bits."""
        return self._text

    def rows(self) -> list[Row]:
        """A row for each estimator that has positions and instant."""
        rows: list[Row] = []
        for each in self.estimators.values():
            found = {
                "position_error_m": each.position_errors.tolist(),
                "aligned_position_error_m": each.aligned_position_errors.tolist(),
            }
            known = {key: values for key, values in found.items() if values}
            for k, time in enumerate(self.instants.tolist() if known else ()):
                rows.append({"name": each.name, "time_s": time, **{key: values[k] for key, values in known.items()}})
        return rows

    @property
    def stamps(self) -> Floats:
        """When was measured, s: K."""
        return _numbers(self._document["stamps"])

    @property
    def instants(self) -> Floats:
        """When positions are compared, s: T."""
        return _numbers(self._document["instants"])

    @property
    def missing(self) -> int:
        """How many distances are missing."""
        return int(self._document["missing"])

    @property
    def truth(self) -> Floats:
        """The true motion, centred, m/s^l: (L + 1) x N x D."""
        return _numbers(self._document["truth"])

    @property
    def sensor_from_world(self) -> Floats:
        """`Q`, from the frame of the truth to that of the accelerometers: D x D."""
        return _numbers(self._document["sensor_from_world"])

    def __reduce__(self) -> tuple[type["KinematicsRun"], tuple[str]]:
        return type(self), (self._text,)

    def __repr__(self) -> str:
        return f"<rangelab.KinematicsRun {self.name!r}: {', '.join(self.estimators)}>"

    def _repr_html_(self) -> str:
        header = ["", "RMSE of positions, mm", "of velocities, mm/s", "stopped"]
        rows = []
        for each in self.estimators.values():
            errors = [f"{1e3 * error:.3g}" for error in each.coefficient_errors[:2]]
            rows.append([each.label, *errors, *[""] * (2 - len(errors)), each.failure or ""])
        return table(f"Run of {self.name}: {len(self.stamps)} stamps", header, rows)
