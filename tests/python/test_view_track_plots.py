"""The plots of the lab Track: bands by chi-square, the threshold, upright lines, what has no logarithm."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from rangelab import Recording, Scenario, chi_squared_interval
from rangelab.view.labs import computed, lab_of
from rangelab.view.limits import magnified
from rangelab.view.looks import Look
from rangelab.view.picture import Wish
from rangelab.view.plots import Band, Line, Plot
from rangelab.view.uprights import Upright, with_uprights
from viewer_labs import shown

ROOM = Scenario.preset("room").replace(steps=12)
TRIALS = 40


def plot_of(source: Any, title: str, **wish: Any) -> Plot:
    """The plot with a title that begins so."""
    (found,) = [plot for plot in computed(Wish(source, lab_of(source), **wish)).plots() if plot.title.startswith(title)]
    return found


def band(degrees: float, trials: int = 1) -> tuple[float, float]:
    """As the mean of so many trials has it."""
    low, high = chi_squared_interval(degrees * trials, 0.95)
    return low / (degrees * trials), high / (degrees * trials)


def edges(plot: Plot) -> list[tuple[float, float]]:
    """Of its bands."""
    return [(each.low, each.high) for each in plot.bands]


@pytest.mark.parametrize(("title", "degrees"), [("NEES", (6, 12)), ("NIS", (25, 30))])
def test_each_number_of_degrees_has_its_band(title: str, degrees: tuple[int, ...]) -> None:
    assert edges(plot_of(ROOM, f"{title} / dof")) == [band(each) for each in degrees]
    averaged = plot_of(ROOM, f"Mean {title} / dof", study=ROOM.study(TRIALS))
    assert edges(averaged) == [band(each, TRIALS) for each in degrees]
    assert band(degrees[0], TRIALS)[1] < 1.2 < band(degrees[0])[1]


def test_estimators_that_are_not_there_have_no_band() -> None:
    lone = ROOM.replace({"estimators.enabled": ["eskf-raw"]})
    assert edges(plot_of(lone, "NEES")) == [band(6)]
    assert edges(plot_of(lone, "NIS")) == [band(30)]
    assert plot_of(ROOM.replace({"estimators.enabled": []}), "NEES").lines == ()


def test_the_band_of_innovations_is_that_of_steps_that_miss_nothing() -> None:
    scenario = ROOM.replace({"estimators.enabled": ["kf"], "missing_probability": 0.2}, steps=60)
    freedom = scenario.run()["kf"].numbers("nis_degrees_of_freedom")
    assert freedom.min() < freedom.max()
    assert edges(plot_of(scenario, "NIS")) == [band(freedom.max())]


def test_what_is_not_known_of_a_recording_is_no_plot() -> None:
    document = ROOM.simulate().to_dict()
    for epoch in document["epochs"]:
        del epoch["truth"]
    assert plot_of(Recording(document), "NEES").lines == ()
    assert edges(plot_of(Recording(document), "NIS")) == [band(25), band(30)]


def test_the_threshold_is_a_line_of_the_defect_where_it_is_one_number() -> None:
    def thresholds(**changes: Any) -> list[Line]:
        changed = ROOM.replace({f"estimators.{key}": value for key, value in changes.items()})
        return [line for line in plot_of(changed, "Defect").lines if line.look.label.startswith("ε")]

    (line,) = thresholds()
    assert (line.look.label, set(line.values)) == ("ε = 0.15", {0.15})
    assert not thresholds(threshold={"kind": "relative", "epsilon": 1.5})
    assert not thresholds(threshold={"kind": "absolute", "epsilon": 0.0})
    assert not thresholds(enabled=["kf"])


def test_an_upright_stands_across_the_lines_and_bends_none() -> None:
    x, look = np.array([1.0, 10.0, 100.0]), Look("a", "kf")
    line = Line(look, np.array([1.0, 100.0, 10.0]), spread=np.full(3, 0.5))
    dots = Line(look, np.array([5.0, np.nan, 7.0]), dots=True)
    plot = Plot("", x, (line, dots), logarithmic_x=True, uprights=(Upright(10**0.5, Look("here", "bound")),))
    found = with_uprights(plot)
    assert np.allclose(found.x, [1, 10**0.5, 10**0.5, 10, 100])
    assert np.allclose(found.lines[0].values, [1, 10, 10, 100, 10])
    assert np.allclose(found.lines[1].values, [5, np.nan, np.nan, np.nan, 7], equal_nan=True)
    # From the lower edge of the band to the upper one.
    assert np.allclose(found.lines[2].values, [np.nan, 0.5, 100.5, np.nan, np.nan], equal_nan=True)
    level = with_uprights(replace(plot, logarithmic=False, logarithmic_x=False))
    assert np.allclose(level.lines[0].values[1], 1 + 99 * (10**0.5 - 1) / 9)
    assert level.limits is not None
    assert level.limits[0] < 0.5 < 100.5 < level.limits[1]


def test_numbers_that_are_close_together_have_a_scale_of_their_own() -> None:
    def scaled(values: list[float]) -> Plot:
        line = Line(Look("a", "kf"), np.array(values))
        return magnified(Plot("", np.arange(3.0), (line,), bands=(Band(0.9, 1.1, ""),)))

    near = scaled([np.nan, 0.8, 1.3])
    assert near.limits is not None
    assert not near.logarithmic
    assert 0.7 < near.limits[0] < 0.8 < 1.3 < near.limits[1] < 1.4
    assert scaled([np.nan, 0.8, 30.0]).logarithmic


def test_what_has_no_logarithm_is_drawn_nowhere() -> None:
    with shown(ROOM) as (_, client):
        scales = [message["props"]["scales"]["y"] for message in client.of_type("GuiUplotMessage")]
    assert scales
    assert all(scale == {"distr": 3, "clamp": np.inf} for scale in scales)
