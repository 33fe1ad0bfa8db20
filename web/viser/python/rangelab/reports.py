"""What runs have in common: parts by name, each of which may have failed with a reason."""

import json
from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar

from ._core import UnknownName
from .arrays import Floats, Part
from .frames import Row, rows_to_pandas, rows_to_polars

if TYPE_CHECKING:
    import pandas
    import polars

Core = TypeVar("Core")


class Named(Protocol):
    """A part of a run."""

    name: str
    label: str


PartRun = TypeVar("PartRun", bound=Named)


class CompiledPart(Generic[Core]):
    """One part of a compiled run, by its number there."""

    def __init__(self, run: Core, index: int, part: Part) -> None:
        self._run, self._index = run, index
        self.name, self.label = part[:2]
        self.failure: tuple[int, str] | None = None if part[2] is None else (part[2], part[3] or "")
        """The step from which on it gives nothing, and why."""

    def __repr__(self) -> str:
        return f"<rangelab.{type(self).__name__} {self.label}>"


class PoseCore(Protocol):
    """A compiled run of estimators of position and orientation."""

    def position_covariances(self, part: int, /) -> Floats:
        """m^2: K x D x D."""
        ...

    def rotation_covariances(self, part: int, /) -> Floats:
        """rad^2: K x A x A."""
        ...

    def numbers(self, part: int, name: str, /) -> Floats:
        """K."""
        ...


PoseRun = TypeVar("PoseRun", bound=PoseCore)


class PosePart(CompiledPart[PoseRun]):
    """What one estimator of position and orientation made of all steps, A = 3 angles in space and 1 in the plane."""

    @property
    @abstractmethod
    def orientations(self) -> Floats:
        """K x D x D."""

    @property
    @abstractmethod
    def positions(self) -> Floats:
        """m: K x D."""

    @property
    def position_covariances(self) -> Floats:
        """m^2: K x D x D."""
        return self._run.position_covariances(self._index)

    @property
    def rotation_covariances(self) -> Floats:
        """Of the rotation vector of the error in the world frame, rad^2: K x A x A."""
        return self._run.rotation_covariances(self._index)

    @property
    def orientation_errors(self) -> Floats:
        """Geodesic angles to the truth, rad: K."""
        return self.numbers("orientation_error")

    @property
    def position_errors(self) -> Floats:
        """Distances to the truth, m: K."""
        return self.numbers("position_error")

    def numbers(self, name: str) -> Floats:
        """A number a step, by its name in the crate: K."""
        return self._run.numbers(self._index, name)


class RunReport(ABC, Generic[PartRun]):
    """One trial or recording through estimators: `run["kf"]` is what one of them made of it."""

    _what = "estimator"

    def __init__(self, parts: dict[str, PartRun]) -> None:
        self._parts = parts

    @abstractmethod
    def to_json(self) -> str:
        """The run as JSON; every number comes back as the same bits."""

    @abstractmethod
    def rows(self) -> list[Row]:
        """The run as a table, units in the names of the columns."""

    def to_dict(self) -> dict[str, Any]:
        """The run as a dictionary, a copy."""
        document: dict[str, Any] = json.loads(self.to_json())
        return document

    def to_pandas(self) -> "pandas.DataFrame":
        """The table as a pandas frame (extra `frames`)."""
        return rows_to_pandas(self.rows())

    def to_polars(self) -> "polars.DataFrame":
        """The table as a polars frame (extra `frames`)."""
        return rows_to_polars(self.rows())

    def __getitem__(self, name: str) -> PartRun:
        try:
            return self._parts[name]
        except KeyError:
            known = ", ".join(self._parts)
            raise UnknownName(f'no {self._what} of this run is called "{name}"; there are: {known}') from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._parts)

    def __len__(self) -> int:
        return len(self._parts)
