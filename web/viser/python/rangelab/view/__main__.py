"""`python -m rangelab.view [SCENARIO | RECORDING | PRESET | LINK]`."""

import argparse
import sys
from pathlib import Path

from .._core import Error
from .port import PortTakenError

EXAMPLES = """\
examples:
  python -m rangelab.view                         the preset "room"
  python -m rangelab.view planar --port 8090      another preset, another port
  python -m rangelab.view room --lab localize     one epoch in many trials
  python -m rangelab.view indoor-u --theme dark   an IMU and beacons
  python -m rangelab.view kinematics-paper        nodes without anchors
  python -m rangelab.view mine.json               a scenario of any of these, or a recording
  python -m rangelab.view 'https://...#v1....'    a link of the page
  python -m rangelab.view room --save room.html   one HTML (or .viser) file that plays the run, and no server
"""


def main(arguments: list[str] | None = None) -> int:
    """Opens the viewer until Ctrl-C; the exit code is 1 where there is an error, in a sentence."""
    options = _options(arguments)
    try:
        from .source import opened
        from .viewer import Viewer
    except ModuleNotFoundError as missing:
        return _failed(f"{missing}: install the viewer with pip install 'rangelab[view]'")
    try:
        viewer = Viewer(
            opened(options.what),
            lab=options.lab,
            theme=options.theme,
            host=options.host,
            port=options.port,
            page=options.page,
        )
    except (Error, PortTakenError, OSError) as error:
        return _failed(str(error))
    if options.save:
        viewer.save(options.save)
        viewer.stop()
        print(f"rangelab: wrote {options.save}", flush=True)  # noqa: T201
        return 0
    print(f"rangelab: {viewer.address}  (Ctrl-C ends it)", flush=True)  # noqa: T201
    try:
        viewer.wait()
    except KeyboardInterrupt:
        viewer.stop()
    return 0


def _options(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m rangelab.view",
        description="Show a scenario or recording; drag anchors and see the estimates move.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("what", nargs="?", default="room", help="a preset, a file, or a link of the page [room]")
    parser.add_argument("--host", default="127.0.0.1", help="whom to serve: 0.0.0.0 for the whole network [127.0.0.1]")
    parser.add_argument("--port", type=int, default=8080, help="0 takes any free one [8080]")
    parser.add_argument("--lab", choices=("track", "localize"), help="how a rigid body is shown [track]")
    parser.add_argument("--theme", choices=("light", "dark", "projector"), default="light", help="colours [light]")
    parser.add_argument("--page", default="", help="where the page is served, for its links")
    parser.add_argument("--save", type=Path, help="write FILE.html or FILE.viser and end")
    return parser.parse_args(arguments)


def _failed(sentence: str) -> int:
    print(f"error: {sentence}", file=sys.stderr)  # noqa: T201
    return 1


if __name__ == "__main__":
    sys.exit(main())
