"""The port that the viewer is served at: the one asked for, or an error; viser itself would quietly take another."""

import socket


class PortTakenError(Exception):
    """Someone else listens there."""


def free_port(host: str, port: int) -> int:
    """The port, or any free one for 0.

    Raises:
        PortTakenError: with advice.
    """
    with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((host, port))
        except OSError as error:
            raise PortTakenError(
                f"port {port} of {host} cannot be used ({error.strerror}): another viewer may still run there; "
                f"end it, or choose another port with --port {port + 1}, or any free one with --port 0"
            ) from None
        found: int = probe.getsockname()[1]
        return found
