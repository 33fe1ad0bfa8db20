"""The read-out of the viewer: the crate's errors and bounds, in the units of its heads."""

import re
from typing import Any

import numpy as np
import pytest
from rangelab import IndoorScenario, KinematicsScenario, Recording, Scenario
from rangelab.view.labs import computed, lab_of
from rangelab.view.picture import Picture, Source, Wish
from rangelab.view.readout import Table, reading
from rangelab.view.themes import THEMES
from viewer_client import until
from viewer_labs import shown

DEGREES = float(np.degrees(1.0))
ROOM = Scenario.preset("room").replace(steps=12)


def picture(source: Source, lab: str | None = None) -> Picture:
    return computed(Wish(source, lab_of(source, lab)))


def row(table: Table, label: str) -> list[float]:
    """The numbers of a row."""
    (found,) = [each for each in table.rows if each.look.label == label]
    return list(found.numbers)


def of_trial(study: Any, name: str, keys: tuple[str, str]) -> list[np.ndarray]:
    """Angle (deg) and position (m) at each step, of a study of one trial."""
    return [study.curve(name, keys[0]).values * DEGREES, study.curve(name, keys[1]).values]


def test_track_tells_errors_and_bounds_of_the_step_and_of_the_run() -> None:
    table, study = picture(ROOM).readout(4), ROOM.study(1)
    for label, name, keys in (
        ("UC-KF", "uc-kf", ("rms_angle", "rmse_position")),
        ("posterior CRB", "posterior_crb", ("angle", "position")),
    ):
        columns = of_trial(study, name, keys)
        expected = [*(each[4] for each in columns), *(np.sqrt(np.mean(each**2)) for each in columns)]
        assert np.allclose(row(table, label), expected, rtol=1e-12)
    assert [heads for _, heads in table.groups] == 2 * [("orient.\ndeg", "position\nm")]


def test_indoor_tells_what_a_study_of_one_trial_tells() -> None:
    scenario = IndoorScenario.preset("indoor-u")
    table, report = picture(scenario).readout(30), scenario.study(1).to_dict()
    (mekf,) = [each["summary"] for each in report["filters"] if each["name"] == "mekf"]
    step = mekf["steps"][30]
    expected = [
        step["angle"]["value"] * DEGREES,
        step["position"]["value"],
        step["largest_singular_value"]["value"],
        mekf["angle"]["value"] * DEGREES,
        mekf["position"]["value"],
        mekf["nees"]["value"],
    ]
    assert np.allclose(row(table, "MEKF"), expected, rtol=1e-9)


def test_localize_tells_a_trial_and_the_averages_of_the_crate() -> None:
    found = picture(ROOM, "localize")
    table, study = found.readout(7), ROOM.localization_study(trials=len(found.times))
    angle, position, *overall = row(table, "OUC-LS")
    (one,) = [each["errors"] for each in ROOM.localize(7)["estimators"] if each["name"] == "ouc-ls"]
    assert (angle, position) == (one["angle"] * DEGREES, one["position"])
    keys = ("rms_angle", "rmse_position", "rmse_sensors", "reflection_rate", "iterations")
    expected = [study.curve("ouc-ls", key).values[0] for key in keys]
    assert np.allclose(overall, np.array(expected) * [DEGREES, 1, 1, 100, 1], rtol=1e-12)
    (bound,) = [each for each in ROOM.localize(0)["bounds"] if each["name"] == "uc_crb"]
    assert np.allclose(row(table, "UC-CRB")[:2], [bound["angle"] * DEGREES, bound["position"]])
    assert np.isnan(row(table, "classical LS")[:2]).all()


def test_anchorless_tells_the_motion_at_time_zero_beside_its_bounds() -> None:
    scenario = KinematicsScenario.preset("kinematics-paper")
    table, run, bound = picture(scenario).readout(5), scenario.run(), scenario.bound(accelerations=True)
    name = "maximum-likelihood-accelerometers"
    expected = [run[name].position_errors[5], *run[name].coefficient_errors[:3]]
    numbers = row(table, "ML, all readings")
    assert np.allclose(numbers[: len(expected)], 1e3 * np.array(expected))
    orders = range(len(run.truth))
    assert np.allclose(
        row(table, "CRB, all readings")[: 1 + len(orders)],
        1e3 * np.array([bound.position_rmse(run.instants[5])[0], *(bound.coefficient_rmse(order) for order in orders)]),
    )


def test_an_estimator_that_stopped_says_so() -> None:
    epoch = {"interval": 1, "ranges": [[1e9, 1e9], [1, 1], [0, 0]]}
    recording = Recording(
        {
            "version": 1,
            "dimension": 2,
            "anchors": [[0, 0], [1, 0], [0, 1]],
            "sensors": [[0, 0], [1, 0]],
            "noise": {"kind": "range", "sigma": 1e-6},
            "initial": {"covariance": 1e12},
            "epochs": [epoch],
        }
    )
    found = picture(recording)
    stopped = {each.label for each in found.run.estimators.values() if each.failure}
    assert stopped, "this recording stops no estimator any more"
    remarks = {each.look.label: each.remark for each in found.readout(0).rows}
    assert {label for label, remark in remarks.items() if remark} == stopped
    assert {remarks[label] for label in stopped} == {"stopped at step 1"}


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (0.012345, "0.0123"), (-1.5, "−1.50"), (9.999, "10.0"), (1234.5, "1234"), (2e-7, "2.0e−7")],
)
def test_numbers_have_three_digits(value: float, text: str) -> None:
    assert reading(value) == text
    assert reading(np.nan) == "–"


def test_the_table_follows_the_step() -> None:
    with shown(ROOM) as (viewer, client):

        def told() -> str:
            sent = [m["props"]["content"] for m in client.of_type("GuiHtmlMessage")]
            later = [m["updates"]["content"] for m in client.of_type("GuiUpdateMessage") if "content" in m["updates"]]
            return str([*sent, *later])

        def number(step: int) -> str:
            return reading(DEGREES * viewer.shown.run["uc-kf"].orientation_errors[step])

        until(lambda: number(len(ROOM.simulate().run().times) - 1) in told())
        assert THEMES["light"].css("uc-kf") in told()
        assert not re.search(rf">{re.escape(number(3))}<", told())
        client.set(client.control("step"), 3)
        until(lambda: re.search(rf">{re.escape(number(3))}<", told()))
