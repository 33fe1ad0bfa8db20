"""The same bits as the command line and the page: texts are compared whole."""

import re
from collections.abc import Callable

import numpy as np
import pytest
import rangelab
from conftest import ROOT, fingerprint
from rangelab import IndoorScenario, Recording, Run, Scenario

Cli = Callable[..., str]


@pytest.mark.parametrize("name", ["room", "planar", "rod", "tracking-paper"])
def test_runs_are_those_of_the_page(name: str) -> None:
    lines = (ROOT / f"tests/golden/{name}.txt").read_text().splitlines()
    golden = {kind: found for found, kind in (line.split(" ", 1) for line in lines)}
    text = Scenario.preset(name).run().to_json()
    assert fingerprint(text.encode()) == golden["json"]
    assert fingerprint(text.replace("1", "2", 1).encode()) != golden["json"]


@pytest.mark.parametrize("name", ["room", "planar"])
def test_runs_are_those_of_the_command_line(cli: Cli, name: str) -> None:
    scenario = Scenario.preset(name)
    assert scenario.run(3).to_json().strip() == cli("run", name, "--trial", "3").strip()
    assert scenario.run(3).to_csv().strip() == cli("run", name, "--trial", "3", "--format", "csv").strip()
    assert scenario.simulate(3).to_json().strip() == cli("simulate", name, "--trial", "3").strip()


def test_a_recording_gives_the_run_of_the_command_line(cli: Cli) -> None:
    recording = Scenario.preset("missing-ranges").simulate()
    expected = cli("estimate", "-", "--estimators", "kf,uc-kf", given=recording.to_json())
    assert recording.run({"enabled": ["kf", "uc-kf"]}).to_json().strip() == expected.strip()


def test_studies_are_those_of_the_command_line_on_any_number_of_threads(
    cli: Cli,
) -> None:
    expected = cli("study", "room", "--trials", "50", "--format", "json").strip()
    for threads in (1, 3):
        assert Scenario.preset("room").study(50, threads=threads).to_json() == expected


def test_budgets_and_figures_are_those_of_the_command_line(cli: Cli) -> None:
    arguments = (
        "study",
        "tracking-paper",
        "--trials",
        "30",
        "--format",
        "json",
        "--thresholds",
        "0.1,0.2",
    )
    assert Scenario.preset("tracking-paper").budget_study([0.1, 0.2], 30).to_json() == cli(*arguments).strip()
    figure = rangelab.figure("localization-2", 20, seed=5)
    for text, kind in ((figure.to_json(), "json"), (figure.csv, "csv")):
        arguments = (
            "figure",
            "localization-2",
            "--trials",
            "20",
            "--seed",
            "5",
            "--format",
            kind,
        )
        assert text.strip() == cli(*arguments).strip()


def test_localization_studies_are_those_of_the_command_line(cli: Cli) -> None:
    study = Scenario.preset("room").localization_study([{"kind": "range", "sigma": 0.02}], 60)
    document = Scenario.preset("room").replace({"noise": {"kind": "range", "sigma": 0.02}})
    assert study.to_json() == document.localization_study(trials=60, threads=1).to_json()


def test_documents_come_back_as_the_same_bits() -> None:
    for preset in rangelab.presets():
        scenario = Scenario.preset(preset["name"])
        assert Scenario(scenario.to_dict()) == scenario
        assert rangelab.from_link(rangelab.to_link(scenario)) == scenario
        run = scenario.replace(steps=3).run()
        assert Run.from_json(run.to_json()).to_json() == run.to_json()
    recording = Scenario.preset("room").simulate()
    assert Recording(recording.to_dict()).to_json() == recording.to_json()
    indoor = IndoorScenario.preset()
    assert IndoorScenario(indoor.to_dict()).to_json() == indoor.to_json()


def test_arrays_are_the_numbers_of_the_document() -> None:
    run = Scenario.preset("missing-ranges").run()
    document = run.to_dict()
    for part in document["estimators"]:
        each = run[part["name"]]
        steps = part["steps"]
        assert np.array_equal(each.orientations, [step["posterior"]["orientation"] for step in steps])
        assert np.array_equal(each.positions, [step["posterior"]["position"] for step in steps])
        assert np.array_equal(each.prior_positions, [step["prior"]["position"] for step in steps])
        assert np.array_equal(each.position_covariances, [step["position_covariance"] for step in steps])
        assert np.array_equal(each.position_errors, [step["errors"]["position"] for step in steps])
        assert np.array_equal(each.orientation_errors, [step["errors"]["angle"] for step in steps])
        assert np.array_equal(each.events, [step["event"] for step in steps])
    for part in document["bounds"]:
        traces = [np.nan if step is None else step["position_trace"] for step in part["steps"]]
        assert np.array_equal(run.bounds[part["name"]].position ** 2, np.sqrt(traces) ** 2, equal_nan=True)
    missing = {(k, *pair) for k, pairs in enumerate(document["missing"]) for pair in pairs}
    assert missing == {tuple(int(i) for i in index) for index in np.argwhere(~run.present)}
    assert missing


def test_every_page_link_is_read_and_every_bad_one_refused() -> None:
    link = rangelab.to_link(Scenario.preset("room"), "https://example.org/page/")
    assert re.fullmatch(r"https://example\.org/page/#v1\.[A-Za-z0-9_-]+", link)
    for spoiled in (
        link[:-9],
        link.replace("#v1.", "#v2."),
        "nothing",
        "#v1.A",
        f"#v1.{'A' * 9000}",
    ):
        with pytest.raises(rangelab.Error, match="link"):
            rangelab.from_link(spoiled)
