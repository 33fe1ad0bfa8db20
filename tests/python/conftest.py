"""What the tests of the Python package share."""

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="session")
def cli() -> Callable[..., str]:
    """The command line, built from the same tree: arguments in, what it printed out."""
    subprocess.run(["cargo", "build", "--quiet", "--bin", "rangelab"], cwd=ROOT, check=True)

    def call(*arguments: str, given: str | None = None) -> str:
        command = [str(ROOT / "target/debug/rangelab"), *arguments]
        return subprocess.run(command, input=given, check=True, capture_output=True, text=True).stdout

    return call
