"""Monte-Carlo in the viewer: the crate's averages in the plots, with bands, and an end before its time."""

import threading
from typing import Any

import numpy as np
import pytest
from rangelab import IndoorScenario, Scenario
from rangelab.view.labs import computed, lab_of
from rangelab.view.picture import Picture, Wish
from rangelab.view.plots import Plot
from viewer_client import until
from viewer_labs import shown

DEGREES = float(np.degrees(1.0))
ROOM = Scenario.preset("room").replace(steps=10)
INDOOR = IndoorScenario.preset("indoor-u")


def averaged(scenario: Any, trials: int) -> Picture:
    return computed(Wish(scenario, lab_of(scenario), study=scenario.study(trials)))


def line(plot: Plot, label: str) -> Any:
    (found,) = [each for each in plot.lines if each.look.label == label]
    return found


def test_trackers_have_bands_of_two_standard_errors() -> None:
    study, plots = ROOM.study(40), averaged(ROOM, 40).plots()
    for plot, label, name, figure, factor in (
        (plots[0], "UC-KF", "uc-kf", "rms_angle", DEGREES),
        (plots[0], "posterior CRB", "posterior_crb", "angle", DEGREES),
        (plots[1], "KF", "kf", "rmse_position", 1.0),
        (plots[3], "ESKF", "eskf", "nees", 1.0),
    ):
        curve, found = study.curve(name, figure), line(plot, label)
        assert np.allclose(found.values, factor * curve.values, rtol=1e-14)
        upper, lower = found.edges
        assert np.allclose((upper - lower) / 4, factor * curve.standard_errors, rtol=1e-6)
    assert np.isnan(line(plots[4], "KF").values[0])


def test_the_readout_tells_the_averages_of_the_step() -> None:
    study, found = ROOM.study(40), averaged(ROOM, 40)
    (uc,) = [row for row in found.readout(6).rows if row.look.label == "UC-KF"]
    angle, position = study.curve("uc-kf", "rms_angle"), study.curve("uc-kf", "rmse_position")
    wanted = [DEGREES * angle.values[6], position.values[6], DEGREES * angle.standard_errors[6]]
    assert np.allclose(uc.numbers[:3], wanted)
    assert np.isclose(uc.numbers[4], study.curve("uc-kf", "nees").values[6])


def test_indoor_filters_are_averaged() -> None:
    report, found = INDOOR.study(20).to_dict(), averaged(INDOOR, 20)
    (mekf,) = [each["summary"] for each in report["filters"] if each["name"] == "mekf"]
    steps = [step["position"] for step in mekf["steps"]]
    shown_line = line(found.plots()[0], "MEKF")
    assert np.allclose(shown_line.values, [step["value"] for step in steps])
    assert np.allclose(shown_line.spread, [2 * step["standard_error"] for step in steps])
    (row,) = [row for row in found.readout(3).rows if row.look.label == "MEKF"]
    assert np.allclose(row.numbers[4:], [mekf["position"]["value"], mekf["nees"]["value"]])


def test_one_trial_has_no_bands() -> None:
    assert not [each for plot in averaged(ROOM, 1).plots() for each in plot.lines if each.edges]


@pytest.mark.parametrize("scenario", [ROOM, INDOOR])
def test_averages_are_asked_for_shown_and_left(scenario: Any) -> None:
    with shown(scenario) as (viewer, client):
        client.set(client.control("trials"), 40)
        client.press("Average over trials, or stop")
        until(lambda: viewer.shown.wish.study is not None)
        assert viewer.shown.wish.study == scenario.study(40)

        def banded() -> list[Any]:
            plots = [m["props"] for m in client.of_type("GuiUplotMessage")]
            return [plot for plot in plots if plot["title"] == "Position RMSE, m" and plot["bands"]]

        until(banded)
        plot = banded()[0]
        assert all(plot["series"][edge]["label"] == "" for band in plot["bands"] for edge in band["series"])
        client.press("Show the single run")
        until(lambda: viewer.shown.wish.study is None)


def test_an_edit_ends_a_study_and_takes_averages_away() -> None:
    with shown(ROOM) as (viewer, client):
        client.set(client.control("trials"), 20)
        client.press("Average over trials, or stop")
        until(lambda: viewer.shown.wish.study is not None)
        client.set(client.control("seed"), 5)
        until(lambda: viewer.shown.wish.study is None)
        client.set(client.control("trials"), 100_000)
        client.press("Average over trials, or stop")
        until(lambda: "of 100000 trials" in str(client.of_type("GuiUpdateMessage")))
        client.set(client.control("seed"), 6)
        until(lambda: "The scene has changed" in str(client.of_type("GuiUpdateMessage")))
        assert viewer.shown.wish.study is None


def test_a_study_that_is_stopped_shows_what_it_has() -> None:
    with shown(ROOM) as (viewer, client):
        client.set(client.control("trials"), 100_000)
        client.press("Average over trials, or stop")
        until(lambda: "20 of 100000 trials" in str(client.of_type("GuiUpdateMessage")))
        client.press("Average over trials, or stop")
        until(lambda: viewer.shown.wish.study is not None)
        study = viewer.shown.wish.study
        assert study is not None
        assert 20 <= study.trials < 100_000
        until(lambda: f"Stopped after {study.trials} trials." in str(client.of_type("GuiUpdateMessage")))


def test_a_study_ends_with_the_viewer() -> None:
    with shown(ROOM) as (_, client):
        client.set(client.control("trials"), 100_000)
        client.press("Average over trials, or stop")
        until(lambda: "of 100000 trials" in str(client.of_type("GuiUpdateMessage")))
    until(lambda: "rangelab-study" not in {thread.name for thread in threading.enumerate()}, 10)
