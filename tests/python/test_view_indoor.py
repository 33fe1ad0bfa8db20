"""The Indoor lab of the viewer: what it tells is what the crate computed, in the page's words."""

import re
from collections.abc import Iterator
from typing import Any
from unittest.mock import MagicMock

import numpy as np
import pytest
from conftest import ROOT
from rangelab import IndoorScenario, chi_squared_interval
from rangelab.view.labs import computed, indoor_cautions
from rangelab.view.labs.indoor_distribution import distribution_plots, shares
from rangelab.view.labs.indoor_lessons import lessons
from rangelab.view.labs.indoor_levels import Level
from rangelab.view.labs.indoor_panel import TELLING, lesson
from rangelab.view.picture import Picture, Wish
from rangelab.view.plots import Plot
from viewer_client import until
from viewer_labs import shown

PAGE = ROOT / "web/page/src/labs/indoor"
U = IndoorScenario.preset("indoor-u")
DEGREES = float(np.degrees(1.0))


def picture(scenario: IndoorScenario, trials: int = 0) -> Picture:
    return computed(Wish(scenario, "indoor", study=scenario.study(trials) if trials else None))


def plot(plots: list[Plot], start: str) -> Plot:
    (found,) = [each for each in plots if each.title.startswith(start)]
    return found


def texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for each in value.values():
            yield from texts(each)


def test_cautions_are_those_of_the_page() -> None:
    page = " ".join(re.sub(r"\s+", " ", each.read_text()) for each in sorted((PAGE / "controls").iterdir()))
    ours = {name: value for name, value in vars(indoor_cautions).items() if name.isupper() and name != "TRAP"}
    sentences = [text.removeprefix(indoor_cautions.TRAP) for text in texts(ours)]
    assert len(sentences) > 20
    assert [text for text in sentences if text not in page] == []


@pytest.mark.parametrize(
    ("convention", "positions", "told"),
    [
        ("sample", {"ekf": 0.5, "ekf-rie": 0.25, "mekf": 0.05}, "EKFRie is 2 times as good as EKF."),
        ("sample", {"ekf": 0.5, "ekf-rie": 0.25, "mekf": 0.05}, "MEKF, which integrates exactly, is 5 times as good"),
        ("disc", {"ekf": 0.11, "ekf-rie": 0.1, "mekf": 0.4}, "MEKF is 4 times as bad (0.400 m): ‘disc’ samples match"),
        ("mean", {"ekf": 0.1, "mekf": 0.1}, "All filters agree to half a per cent: the ranges decide alone."),
        ("mean", {"ekf": 0.1, "mekf": 0.101}, "Nearest: EKF, 0.100 m and 0.573°."),
    ],
)
def test_lessons_follow_from_the_errors(convention: str, positions: dict[str, float], told: str) -> None:
    levels = [Level(name, position, 0.01, 1.1, 1.0) for name, position in positions.items()]
    said = [each.text for each in lessons(levels, convention) if each]
    assert any(text.startswith(told) for text in said), said


def test_retraction_alone_is_said_to_do_it_all_where_it_does() -> None:
    def said(bare: float) -> str:
        errors = {"ekf": 0.2, "ekf-rie": 0.1, "ekf-retraction": bare}
        levels = [Level(name, error, 0.01, 1.0, 1.0) for name, error in errors.items()]
        return " ".join(each.text for each in lessons(levels, "sample") if each)

    assert "all by retraction: that alone equals it to five digits" in said(0.1 * (1 + 5e-6))
    assert "retraction alone is 10 % worse than it" in said(0.11)


def test_the_sentences_are_of_the_run_or_of_the_averages() -> None:
    run, one, many = U.run(), picture(U).sentences()[0], picture(U, 20).sentences()[0]
    assert f"R has grown by {run['ekf'].singular_values[-1, 0]:.3f}" in one
    assert many.startswith("Mean over 20 trials, ±")
    assert "No filter is switched on." in picture(U.replace({"filters.enabled": []})).sentences()[0]


def test_the_nees_lies_in_bands_that_get_narrow_with_trials() -> None:
    for trials in (1, 20):
        found = picture(U, 0 if trials == 1 else trials).plots()
        (band,) = plot(found, "NEES" if trials == 1 else "Mean NEES").bands
        assert np.allclose((band.low, band.high), np.array(chi_squared_interval(9 * trials)) / (9 * trials), rtol=1e-14)


def test_the_least_singular_values_are_shown_where_they_differ() -> None:
    run = U.run()
    lines = {line.look.label: line.values for line in plot(picture(U).plots(), "Singular values").lines}
    assert np.array_equal(lines["EKF"], run["ekf"].singular_values[:, 0])
    assert np.array_equal(lines["EKF, least"], run["ekf"].singular_values[:, 2])
    assert "MEKF, least" not in lines


def test_distributions_are_those_of_the_report() -> None:
    report = U.study(30).to_dict()
    (mekf,) = [each["summary"] for each in report["filters"] if each["name"] == "mekf"]
    for start, figure, factor in (
        ("CDF of pos", "position_distribution", 1),
        ("CDF of or", "angle_distribution", DEGREES),
    ):
        found = plot(picture(U, 30).plots(), start)
        (line,) = [each for each in found.lines if each.look.label == "MEKF"]
        for place, share in zip(found.x[::17], line.values[::17], strict=True):
            assert np.isclose(share, 100 * np.mean(factor * np.array(mekf[figure]) <= place))
        assert (line.values[-1], len(mekf[figure])) == (100, 30)
        assert (found.logarithmic, found.logarithmic_x) == (False, True)


def test_a_curve_ends_at_the_largest_error_of_its_filter() -> None:
    many = np.linspace(1.0, 2.0, 3001)
    parts = {
        name: {"trials": 3001, "failures": 0, "position_distribution": scale * many}
        for name, scale in (("ekf", 10.0), ("mekf", 1.0))
    }
    for summary in parts.values():
        summary["angle_distribution"] = summary["position_distribution"]
    found, _ = distribution_plots(MagicMock(summary=lambda name: parts[name]), list(parts))
    assert len(found.x) < 300
    mekf = found.lines[1].values
    assert (mekf[found.x == 2.0].tolist(), found.x[np.argmax(mekf == 100)]) == ([100.0], 2.0)


def test_trials_that_failed_stay_below_the_top() -> None:
    errors = [1.0, 2.0, 4.0]
    summary = {"trials": 3, "failures": 1, "position_distribution": errors, "angle_distribution": errors}
    found, _ = distribution_plots(MagicMock(summary=lambda _: summary), ["ekf"])
    assert found.x.tolist() == errors
    assert found.lines[0].values.tolist() == [25.0, 50.0, 75.0]
    values, standard_errors = shares(np.array(errors), np.array([0.5, 2.0]), 4)
    assert (values.tolist(), standard_errors.tolist()) == ([0.0, 50.0], [0.0, 25.0])


def test_a_line_is_drawn_for_each_range_of_the_step() -> None:
    found = picture(U.replace({"ranging.missing_probability": 0.4}))
    steps = np.flatnonzero(found.run.fixes)
    holes = next(int(k) for k in steps if 0 < found.run.present[k].sum() < found.run.present[k].size)
    between = int(np.flatnonzero(~found.run.fixes)[0])
    for step, number in ((holes, int(found.run.present[holes].sum())), (between, None)):
        canvas = MagicMock(unit=1.0)
        found.draw(canvas, step, 1.0)
        drawn = {call.args[0]: call.args[1] for call in canvas.lines.call_args_list}
        head = found.readout(step).groups[0][0]
        if number is None:
            assert not [name for name in drawn if name.startswith("/ranges")]
            assert head == "now: IMU alone"
            continue
        assert len(drawn["/ranges"]) == number
        assert {tuple(each) for each in drawn["/ranges"][:, 0]} <= {tuple(each) for each in found.run.beacons}
        assert len(drawn["/ranges/missing"])
        assert head == f"now: {number} of 12 ranges"


def test_lessons_open_presets_with_the_filters_that_tell_them() -> None:
    first = re.search(r"SHOWN_FIRST.*= \[(.*)\]", (PAGE / "filters.ts").read_text())
    assert first is not None
    assert tuple(re.findall(r'"([a-z-]+)"', first[1])) == TELLING
    with shown(U) as (viewer, client):
        client.set(client.control("lesson"), "A staircase")
        until(lambda: viewer.shown.wish.source == lesson("indoor-stair")(U))
        assert list(viewer.shown.run.filters) == list(TELLING)
        client.press("All filters")
        until(lambda: len(viewer.shown.run.filters) == 9)
        client.set(client.control("gravity is felt"), True)
        until(lambda: viewer.shown.wish.source.to_dict()["imu"]["gravity"] == 9.80665)
        client.set(client.control("position on the body, m"), (0.5, 0.1, 0.0))
        until(lambda: np.array_equal(viewer.shown.run.transmitters[0], [0.5, 0.1, 0.0]))


def test_gravity_is_shown_and_typed_with_its_digits() -> None:
    with shown(IndoorScenario.preset("indoor-gravity")) as (viewer, client):
        box = client.control("gravity, m/s²")
        shown_values = [
            each["updates"].get("value") for each in client.of_type("GuiUpdateMessage") if each["uuid"] == box
        ]
        made = [
            each["props"].get("value", each.get("value"))
            for each in client.of_type("GuiNumberMessage")
            if each["uuid"] == box
        ]
        assert 9.80665 in [*shown_values, *made]
        client.set(box, 1.625)
        until(lambda: viewer.shown.wish.source.to_dict()["imu"]["gravity"] == 1.625)
