"""What the viewer shows of any document."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Protocol

from ..arrays import Floats
from ..documents import Written
from ..indoor import IndoorScenario
from ..kinematics import KinematicsScenario
from ..recording import Recording
from ..scenario import Scenario
from ..studies import Study
from .canvas import Canvas
from .plots import Plot
from .readout import Table
from .study_page import StudyPage

Document = Scenario | IndoorScenario | KinematicsScenario
Source = Document | Recording
Change = Callable[[Any], Written]
"""A document with an edit."""


@dataclass(frozen=True)
class Wish:
    """What is to be computed and shown."""

    source: Source
    lab: str
    """A name of `labs.LABS`."""
    trial: int = 0
    field: bool = False
    """Whether the bound over a plane is wished for too."""
    advice: bool = False
    """Whether arrows to better places of the anchors are wished for."""
    fans: bool = False
    """Whether fans of the axes are wished for."""
    study: Study | StudyPage | None = None
    """Averages over many trials of the document, in place of one run's errors, or another study of it."""
    estimators: tuple[str, ...] | None = None
    """Those that run over a recording; None for all. A scenario says so itself."""

    def edited(self, change: Change) -> "Wish":
        """With an edited document, of which there is no study yet, unless it does not depend on what was edited."""
        source = change(self.source)
        assert isinstance(source, Scenario | IndoorScenario | KinematicsScenario)
        kept = self.study if isinstance(self.study, StudyPage) and self.study.holds_for(source) else None
        return replace(self, source=source, study=kept)


@dataclass(frozen=True)
class Handle:
    """Something that is dragged."""

    name: str
    """Its path in the scene."""
    label: str
    place: Floats
    """D, m."""
    moved: Callable[[Floats, Floats], Change]
    """The edit by its new place (D, m) and orientation (D x D)."""
    orientation: Floats | None = None
    """D x D; None for a point."""
    token: str = "anchor"
    size: float = 1.0
    """Of its arrows, beside those of other handles."""
    fixed: tuple[bool, bool, bool] = (False, False, False)
    """Along which axes it cannot be moved."""


class Picture(Protocol):
    """A wish, what the crate made of it, and how that is drawn."""

    wish: Wish
    run: Any
    """What was computed."""

    @property
    def name(self) -> str:
        """What people call it."""
        ...

    @property
    def times(self) -> Floats:
        """Time of each step, s: K."""
        ...

    @property
    def outline(self) -> Floats:
        """Points that the view holds, m: P x D."""
        ...

    @property
    def magnification(self) -> float:
        """How many times as large errors are drawn at first."""
        ...

    def sentences(self) -> list[str]:
        """What there is to be told."""
        ...

    def handles(self) -> list[Handle]:
        """What can be dragged."""
        ...

    def plots(self) -> list[Plot]:
        """Plots along the time."""
        ...

    def readout(self, step: int) -> Table:
        """The errors at a step, and those of the run."""
        ...

    def draw(self, canvas: Canvas, step: int, magnify: float) -> None:
        """Draws a step, its errors so many times as large."""
        ...
