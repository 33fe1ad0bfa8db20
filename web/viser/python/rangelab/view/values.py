"""Values of controls, and who changed them."""

from collections.abc import Callable
from typing import Any


def put(handle: Any, value: Any) -> None:
    """Gives a control a value; nothing is sent where it has it."""
    if handle.value != value:
        handle.value = value


def by_hand(handle: Any, do: Callable[[Any], None]) -> None:
    """Calls `do` with a new value from a browser; what the program itself puts there is no edit."""

    def changed(event: Any) -> None:
        if event.client_id is not None:
            do(handle.value)

    handle.on_update(changed)
