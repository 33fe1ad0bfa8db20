"""A run as a player without a server: a `.viser` recording or one HTML file."""

from collections.abc import Callable

import viser

FRAMES_PER_SECOND = 10


def recorded(server: viser.ViserServer, show: Callable[[int], None], steps: int, ending: str) -> bytes:
    """Shows every step once, a tenth of a second each."""
    show(0)
    serializer = server.get_scene_serializer()
    for step in range(1, steps):
        serializer.insert_sleep(1 / FRAMES_PER_SECOND)
        show(step)
    serializer.insert_sleep(1.0)
    if ending == ".html":
        return serializer.as_html().encode()
    return serializer.serialize()
