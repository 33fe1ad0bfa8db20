"""The page's links: a whole scenario of any lab after the `#` of an address, `#v1.<base64url(deflate(JSON))>`."""

import base64
import binascii
import re
import zlib

from ._core import Error
from .families import AnyScenario, scenario_of

_SHAPE = re.compile(r"v(\d{1,6})\.([A-Za-z0-9_-]+)$")
_MOST_CHARACTERS = 8 * 1024
_MOST_BYTES = 64 * 1024


def to_link(scenario: AnyScenario, page: str = "") -> str:
    """The address that opens a scenario on the page; `page` is where the page is served.

    >>> from rangelab import Scenario
    >>> to_link(Scenario.preset("room"), "https://example.org/").startswith("https://example.org/#v1.")
    True
    """
    packed = zlib.compress(scenario.to_json().encode(), 9)
    return f"{page}#v1.{base64.urlsafe_b64encode(packed).decode().rstrip('=')}"


def from_link(link: str) -> AnyScenario:
    """The scenario of a link, from the whole address or what follows its `#`.

    Raises:
        Error: for a link that is no link, is too long, damaged or of another version.
        InvalidDocument: where it holds no valid scenario.

    """
    part = link.rpartition("#")[2]
    if len(part) > _MOST_CHARACTERS:
        raise Error(f"this link is {len(part)} characters long; at most {_MOST_CHARACTERS} are read")
    match = _SHAPE.match(part)
    if not match:
        raise Error("this link does not have the form #v1.… of a scenario")
    if int(match[1]) != 1:
        raise Error(f"this link has version {int(match[1])}; this rangelab reads version 1")
    return scenario_of(_inflated(match[2]))


def _inflated(text: str) -> str:
    damaged = "this link is damaged or was cut off: its contents do not unpack"
    unpack = zlib.decompressobj()
    try:
        packed = base64.urlsafe_b64decode(text + "=" * (-len(text) % 4))
        found = unpack.decompress(packed, _MOST_BYTES)
        if unpack.unconsumed_tail:
            raise Error(f"this link unpacks to more than {_MOST_BYTES} bytes; no scenario is that long")
        if not unpack.eof:
            raise Error(damaged)
        return found.decode()
    except (binascii.Error, zlib.error, UnicodeDecodeError):
        raise Error(damaged) from None
