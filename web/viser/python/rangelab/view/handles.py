"""Values of controls."""

from typing import Any


def put(handle: Any, value: Any) -> None:
    """Gives a control a value; nothing is sent where it has it."""
    if handle.value != value:
        handle.value = value
