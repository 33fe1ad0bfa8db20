"""The lab Localize of the viewer: the sweep of the noise, what is told of the trials, settings of the page."""

import threading
from typing import Any

import numpy as np
import pytest
from rangelab import Scenario, Study
from rangelab.view import Viewer
from rangelab.view.labs import computed
from rangelab.view.labs.localize import LocalizePicture
from rangelab.view.labs.localize_told import failing, mirroring, nearest
from rangelab.view.labs.noise_sweep import axis_told, level_of, noise_below, noises_of, zetas_by
from rangelab.view.labs.sweep_plots import FIGURES
from rangelab.view.picture import Wish
from viewer_client import until
from viewer_labs import shown

ROOM = Scenario.preset("room").replace(steps=5)


def picture(scenario: Scenario) -> LocalizePicture:
    found = computed(Wish(scenario, "localize"))
    assert isinstance(found, LocalizePicture)
    return found


def settings(viewer: Viewer) -> Any:
    source = viewer.shown.wish.source
    assert isinstance(source, Scenario)
    return source.to_dict()["localize"]


def test_noises_lie_so_many_decibels_below_a_range() -> None:
    for kind in ("toa", "range", "squared_range"):
        for zeta in (0.0, 40.0, 100.0):
            assert level_of(noise_below(kind, 3.9, zeta), 3.9) == pytest.approx(zeta, abs=1e-9)
    # A hundredth of the range is 40 dB below it; the variance of a square is 4 r^2 times as large.
    assert noise_below("range", 5.0, 40.0) == {"kind": "range", "sigma": pytest.approx(0.05)}
    assert noise_below("squared_range", 5.0, 40.0)["sigma"] == pytest.approx(0.1)
    assert "This scene" in axis_told(ROOM.to_dict())


def test_the_fine_sweep_comes_by_itself_and_is_no_edit() -> None:
    with shown(ROOM, "localize") as (viewer, client):
        until(lambda: viewer.shown.wish.study is not None)
        study = viewer.shown.wish.study
        assert isinstance(study, Study)
        assert study.trials == 1000
        zetas = zetas_by(5.0)
        expected = ROOM.localization_study(noises_of(ROOM.to_dict(), zetas), 1000)
        assert study.to_json() == expected.to_json()
        plots = {plot.title: plot for plot in viewer.shown.plots()}
        line = next(each for each in plots["Orientation RMSE, deg"].lines if each.look.label == "OUC-LS")
        curve = expected.curve("ouc-ls", "rms_angle")
        assert np.array_equal(plots["Orientation RMSE, deg"].x, zetas)
        assert np.allclose(line.values, np.degrees(curve.values))
        assert line.spread is not None
        assert np.allclose(line.spread, 2 * np.degrees(curve.standard_errors))
        assert {figure.title for figure in FIGURES} <= set(plots)
        client.set(client.control("seed"), 5)
        until(lambda: viewer.shown.wish.source == ROOM.replace(seed=5))
        until(lambda: viewer.shown.wish.study is not None)
        client.set(client.control("edits"), "undo")
        until(lambda: viewer.shown.wish.source == ROOM)


def test_a_sweep_stops_at_a_press_and_ends_with_the_viewer() -> None:
    with shown(ROOM, "localize") as (viewer, client):
        until(lambda: viewer.shown.wish.study is not None)
        client.set(client.control("trials a point"), 100_000)
        client.set(client.control("seed"), 5)

        def sweeps() -> list[str]:
            return [each.name for each in threading.enumerate() if each.name == "rangelab-sweep"]

        until(lambda: "Sweeping:" in str(client.of_type("GuiUpdateMessage")[-20:]) and sweeps())
        client.press("Stop")
        until(lambda: not sweeps(), seconds=20)
        client.set(client.control("seed"), 6)
        until(sweeps)
        viewer.stop()
        assert not sweeps()


def test_what_trials_show_is_told_in_the_words_of_the_page() -> None:
    angles = {"ls": np.array([0.2, 0.2]), "ouc-ls": np.radians([1.0, 1.0])}
    positions = {"ls": np.array([0.1, 0.1]), "ouc-ls": np.array([0.05, 0.05])}
    bounds = {"uc_crb": (float(np.radians(0.95)), 0.04)}
    told = nearest(angles, positions, bounds, 2)
    assert (
        told
        == "Over 2 trials OUC-LS is nearest: 1.00° and 0.0500 m off; it is at its bound (UC-CRB: 0.950° and 0.0400 m)."
    )
    assert "2.00 times its bound" in nearest(angles, positions, {"uc_crb": (float(np.radians(0.5)), 0.04)}, 2)
    assert nearest(angles, positions, {}, 2).endswith("no bound exists here.")
    assert mirroring({"ls": 0.06, "suc-ls": 0.0}) == "LS mirrors the body in 6.00 % of the trials."
    assert mirroring({"ls": 0.001}) == ""
    assert failing({"ls": ["No.", "No."], "suc-ls": []}, 9) == "LS has no estimate in 2 of 9 trials: No."


def test_the_number_of_trials_travels_with_the_scenario() -> None:
    with shown(ROOM, "localize") as (viewer, client):
        client.set(client.control("trials of the cloud"), 20)
        until(lambda: len(viewer.shown.times) == 20)
        client.set(client.control("OUC-TLS assumes its own σ_e, m"), True)
        until(lambda: settings(viewer)["tls_sigma"] == 0.1)
        client.set(client.control("dots at the tips of the axes"), True)
        until(lambda: "/fans/ouc-ls/disc" in {message["name"] for message in client.of_type("PointCloudMessage")})


def test_hints_that_are_no_number_of_trials_are_left_aside() -> None:
    for hint in ("many", 0, 1e9, True):
        assert len(picture(ROOM.replace(view={"cloud": hint})).times) == 50
