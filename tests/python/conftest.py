"""What the tests of the Python package share."""

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def fingerprint(data: bytes) -> str:
    """FNV-1a of 64 bits, by which `tests/golden` holds texts and numbers; the page's own tests read the same files."""
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return f"{value:016x}"


@pytest.fixture(scope="session")
def cli() -> Callable[..., str]:
    """The command line, built from the same tree: arguments in, what it printed out."""
    subprocess.run(["cargo", "build", "--quiet", "--bin", "rangelab"], cwd=ROOT, check=True)

    def call(*arguments: str, given: str | None = None) -> str:
        command = [str(ROOT / "target/debug/rangelab"), *arguments]
        return subprocess.run(command, input=given, check=True, capture_output=True, text=True).stdout

    return call
