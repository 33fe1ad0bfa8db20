"""What the viewer is asked to show."""

import json
from pathlib import Path

from .._core import Error
from ..link import from_link
from ..recording import Recording
from ..scenario import Scenario

Source = Scenario | Recording


def opened(what: str) -> Source:
    """A link, a file with a scenario or a recording, or a preset.

    Raises:
        Error: with all that is wrong with it.
    """
    if "#" in what:
        return from_link(what)
    path = Path(what)
    if not (path.suffix or path.exists()):
        return Scenario.preset(what)
    text = path.read_text(encoding="utf-8")
    try:
        document = json.loads(text)
    except json.JSONDecodeError as error:
        raise Error(f"{what} is no JSON: {error}") from None
    is_recording = isinstance(document, dict) and "epochs" in document
    return Recording(text) if is_recording else Scenario(text)
