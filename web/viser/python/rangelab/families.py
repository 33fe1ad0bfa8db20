"""Documents of all families: scenarios of a rigid body, indoor scenarios, networks of mobile nodes."""

import json

from ._core import Error, UnknownName
from .indoor import IndoorScenario, indoor_presets
from .kinematics import KinematicsScenario, kinematics_presets
from .scenario import Scenario, presets

AnyScenario = Scenario | IndoorScenario | KinematicsScenario
"""A scenario of any family."""


def scenario_of(text: str) -> AnyScenario:
    """The scenario of a JSON text, of the family that its entries belong to.

    Networks have `coefficients`, scenarios of a rigid body `anchors`; all else is read as indoor.

    Raises:
        InvalidDocument: with every problem, its path, value and limit, in `problems`.
        Error: for text that is no JSON.

    """
    try:
        document = json.loads(text)
    except json.JSONDecodeError as error:
        raise Error(f"this is no JSON: {error}") from None
    if isinstance(document, dict) and "coefficients" in document:
        return KinematicsScenario(text)
    if not isinstance(document, dict) or document.keys() & {"anchors", "dimension", "sensors"}:
        return Scenario(text)
    return IndoorScenario(text)


def preset_names() -> list[str]:
    """The presets of all families."""
    return [each["name"] for _, known in _families() for each in known]


def preset_named(name: str) -> AnyScenario:
    """A preset of any family.

    Raises:
        UnknownName: with the names that exist.

    """
    for family, known in _families():
        if name in (each["name"] for each in known):
            return family.preset(name)
    raise UnknownName(f'no preset is called "{name}"; there are: {", ".join(preset_names())}')


def preset_summary(scenario: AnyScenario) -> str:
    """What a preset teaches; empty for a scenario that is none, or one that was changed."""
    name = scenario.to_dict()["name"]
    summaries = {each["name"]: each["summary"] for _, known in _families() for each in known}
    return summaries[name] if name in summaries and preset_named(name) == scenario else ""


def _families() -> tuple[tuple[type[AnyScenario], list[dict[str, str]]], ...]:
    return (
        (Scenario, presets()),
        (IndoorScenario, indoor_presets()),
        (KinematicsScenario, kinematics_presets()),
    )
