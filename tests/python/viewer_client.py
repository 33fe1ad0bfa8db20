"""A browser's part of viser's protocol, without a browser."""

import os
import threading
import time
from collections.abc import Callable
from typing import Any

import msgspec
import viser
import zstandard
from viser import _messages
from websockets.sync.client import connect


def until(true: Callable[[], object], seconds: float = float(os.environ.get("PATIENCE", "90"))) -> None:
    """Waits for something that happens in another thread."""
    end = time.monotonic() + seconds
    while not true():
        assert time.monotonic() < end, "it did not happen"
        time.sleep(0.02)


class ViewerClient:
    """Connects as a browser does: its camera comes first, without it the server knows no client."""

    def __init__(self, port: int) -> None:
        protocol: Any = f"viser-v{viser.__version__}"
        self._socket = connect(f"ws://127.0.0.1:{port}", subprotocols=[protocol], max_size=None)
        self.messages: list[dict[str, Any]] = []
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        self.send(
            _messages.ViewerCameraMessage(
                wxyz=(1.0, 0.0, 0.0, 0.0),
                position=(0.0, -5.0, 2.0),
                fov=1.0,
                near=0.1,
                far=100.0,
                image_height=600,
                image_width=800,
                look_at=(0.0, 0.0, 0.0),
                up_direction=(0.0, 0.0, 1.0),
            )
        )

    def send(self, message: Any) -> None:
        """One message to the server."""
        self._socket.send(msgspec.msgpack.encode(message.as_serializable_dict()))

    def of_type(self, kind: str) -> list[dict[str, Any]]:
        """What the server sent so far, of one kind."""
        return [message for message in list(self.messages) if message["type"] == kind]

    def drag(self, node: str, position: tuple[float, float, float]) -> None:
        """Moves a gizmo as a hand does: down, along, up."""
        self.send(_messages.TransformControlsDragStartMessage(node))
        self.send(_messages.TransformControlsUpdateMessage(node, (1.0, 0.0, 0.0, 0.0), position))
        self.send(_messages.TransformControlsDragEndMessage(node))

    def set(self, uuid: str, value: Any) -> None:
        """Gives a control of the panel a value."""
        self.send(_messages.GuiUpdateMessage(uuid, {"value": value}))

    def press(self, label: str) -> None:
        """Presses a button."""
        self.set(self.control(label), True)

    def control(self, label: str) -> str:
        """The control with a label, the last one that was sent."""
        for message in reversed(list(self.messages)):
            props = message.get("props")
            if isinstance(props, dict) and props.get("label") == label and "uuid" in message:
                return str(message["uuid"])
        raise LookupError(label)

    def close(self) -> None:
        """Leaves."""
        self._socket.close()
        self._reader.join()

    def _read(self) -> None:
        unpack = zstandard.ZstdDecompressor()
        for frame in self._socket:
            assert isinstance(frame, bytes)
            size, packed = (int.from_bytes(frame[i : i + 8], "little") for i in (0, 8))
            payload = unpack.decompress(frame[16 : 16 + packed], max_output_size=size)
            self.messages.extend(msgspec.msgpack.decode(payload)["messages"])
