"""What the viewer is asked to show."""

import json
from pathlib import Path

from .._core import Error
from ..families import preset_named, scenario_of
from ..link import from_link
from ..recording import Recording
from .picture import Source


def opened(what: str) -> Source:
    """A link, a file with a scenario of any family or a recording, or a preset.

    Raises:
        Error: with all that is wrong with it.
    """
    if "#" in what:
        return from_link(what)
    path = Path(what)
    if not (path.suffix or path.exists()):
        return preset_named(what)
    text = path.read_text(encoding="utf-8")
    try:
        document = json.loads(text)
    except json.JSONDecodeError as error:
        raise Error(f"{what} is no JSON: {error}") from None
    if isinstance(document, dict) and "epochs" in document:
        return Recording(text)
    return scenario_of(text)
