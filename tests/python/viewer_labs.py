"""A viewer of any lab with a client."""

from collections.abc import Iterator
from contextlib import contextmanager

from rangelab.view import Viewer
from rangelab.view.picture import Source
from viewer_client import ViewerClient, until


@contextmanager
def shown(source: Source, lab: str | None = None) -> Iterator[tuple[Viewer, ViewerClient]]:
    """A viewer with a client that has seen its plots."""
    viewer = Viewer(source, lab=lab, port=0)
    client = ViewerClient(viewer.port)
    try:
        until(lambda: client.of_type("TransformControlsMessage") and client.of_type("GuiUplotMessage"))
        yield viewer, client
    finally:
        client.close()
        viewer.stop()
