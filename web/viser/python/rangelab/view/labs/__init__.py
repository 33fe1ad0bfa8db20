"""The labs of the viewer: for each kind of document what is computed, how it is drawn, and which controls it has."""

from collections.abc import Callable
from dataclasses import dataclass

from ..._core import UnknownName
from ...indoor import IndoorScenario
from ...kinematics import KinematicsScenario
from ...recording import Recording
from ...scenario import Scenario
from ..panel import Panel
from ..picture import Picture, Source, Wish
from .anchorless import anchorless
from .anchorless_panel import anchorless_controls
from .explore import explore
from .explore_panel import bound_controls, explore_controls
from .indoor import indoor
from .indoor_panel import indoor_controls
from .localize import localize
from .localize_panel import localize_controls
from .replay import replay_controls
from .track import track
from .track_panel import track_controls


@dataclass(frozen=True)
class Lab:
    """One lab."""

    title: str
    of: type
    """What it shows."""
    compute: Callable[[Wish], Picture]
    tabs: tuple[tuple[str, Callable[[Panel], None]], ...]
    """Its controls, by their titles."""


LABS = {
    "track": Lab("Track", Scenario, track, (("Track", track_controls), ("Bound and room", bound_controls))),
    "explore": Lab("Explore", Scenario, explore, (("Explore", explore_controls),)),
    "localize": Lab("Localize", Scenario, localize, (("Localize", localize_controls),)),
    "indoor": Lab("Indoor", IndoorScenario, indoor, (("Indoor", indoor_controls),)),
    "anchorless": Lab("Anchorless", KinematicsScenario, anchorless, (("Anchorless", anchorless_controls),)),
    "replay": Lab("Recording", Recording, track, (("Recording", replay_controls),)),
}


def lab_of(source: Source, wished: str | None = None) -> str:
    """The name of the lab that shows a document: the one that is wished for, or the first that can.

    Raises:
        UnknownName: where the one that is wished for cannot.
    """
    names = [name for name, lab in LABS.items() if isinstance(source, lab.of)]
    if wished is not None and wished not in names:
        raise UnknownName(f'"{wished}" shows no {type(source).__name__}; there is: {", ".join(names)}')
    return wished or names[0]


def shows_field(lab: str) -> bool:
    """Whether a lab begins with the bound over a plane."""
    return lab == "explore"


def computed(wish: Wish) -> Picture:
    """Runs the crate.

    Raises:
        Error: in a sentence.
    """
    return LABS[wish.lab].compute(wish)
