"""The examples and the tutorial run as they are."""

import doctest
import importlib
import json
import pkgutil
import re
import subprocess
import sys
from pathlib import Path

import nbformat
import rangelab
from conftest import ROOT
from nbclient import NotebookClient


def test_the_tutorial_runs_from_top_to_bottom(tmp_path: Path) -> None:
    notebook = nbformat.read(ROOT / "web/viser/examples/tutorial.ipynb", as_version=4)  # type: ignore[no-untyped-call]
    assert all(not cell.get("outputs") for cell in notebook.cells), "outputs are not kept"
    NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(tmp_path)}}).execute()
    shown = json.dumps([cell.get("outputs") for cell in notebook.cells])
    assert "text/html" in shown
    assert "ranges are not enough to find the pose" in shown


def test_the_example_prints_what_it_says() -> None:
    command = [sys.executable, str(ROOT / "web/viser/examples/track_a_body.py")]
    printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    ratio = re.search(r"([\d.]+) times the bound", printed)
    assert ratio is not None
    assert 0.8 < float(ratio[1]) < 1.5


def test_docstrings_are_true() -> None:
    attempted = 0
    for module in pkgutil.walk_packages(rangelab.__path__, "rangelab."):
        if not module.name.endswith("__main__"):
            found = doctest.testmod(importlib.import_module(module.name))
            assert found.failed == 0, module.name
            attempted += found.attempted
    assert attempted > 4


def test_the_bench_runs_and_finds_the_same_positions() -> None:
    command = [sys.executable, str(ROOT / "web/viser/bench/against_filterpy.py"), "--recordings", "20"]
    printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    apart = [float(found) for found in re.findall(r"apart by at most ([\d.e+-]+) mm", printed)]
    assert len(apart) == 2
    assert max(apart) < 1e-5
    ratios = [float(found) for found in re.findall(r"filterpy / rangelab: ([\d.]+)", printed)]
    assert ratios[0] > 20, printed
