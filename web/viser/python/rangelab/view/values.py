"""Values of controls, and what is done when a hand changes them: one thing after the other."""

import traceback
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any

import viser

_HANDS = ThreadPoolExecutor(1, thread_name_prefix="rangelab-hand")


def put(handle: Any, value: Any) -> None:
    """Gives a control a value; nothing is sent where it has it."""
    if handle.value != value:
        handle.value = value


def in_order(do: Callable[..., None], *what: Any) -> None:
    """Does it after all that came before: viser's own threads would do several things at once, the last one first."""
    _HANDS.submit(do, *what).add_done_callback(_told)


def by_hand(handle: Any, do: Callable[[Any], None]) -> None:
    """Calls `do` with a new value from a browser; what the program itself puts there is no edit."""

    async def changed(event: Any) -> None:
        if event.client_id is not None:
            in_order(do, handle.value)

    handle.on_update(changed)


def at_a_press(button: viser.GuiButtonHandle, do: Callable[[], None]) -> None:
    """Calls `do` when a button is pressed."""

    @button.on_click
    async def _(_: Any) -> None:
        in_order(do)


def _told(done: "Future[None]") -> None:
    problem = done.exception()
    if problem is not None:
        traceback.print_exception(problem)
