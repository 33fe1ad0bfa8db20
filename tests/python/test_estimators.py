"""Every estimator, bound and figure is there, in the shapes it says, and near the truth."""

import pickle

import numpy as np
import pytest
import rangelab
from rangelab import IndoorScenario, Recording, Scenario, Tracker

ROOM = Scenario.preset("room")
PLANAR = Scenario.preset("planar")
TRACKERS = ["kf", "ortho", "uc-kf", "et-kf", "eskf", "eskf-raw"]
LOCALIZERS = [estimator["name"] for estimator in ROOM.localize()["estimators"]]


@pytest.mark.parametrize("scenario", [ROOM, PLANAR], ids=["space", "plane"])
@pytest.mark.parametrize("name", TRACKERS)
def test_a_tracker_alone_is_the_tracker_of_the_run(scenario: Scenario, name: str) -> None:
    recording = scenario.simulate(2)
    track, run = recording.track(name), recording.run()[name]
    assert track.failure is None
    assert np.array_equal(track.orientations, run.orientations)
    assert np.array_equal(track.positions, run.positions)
    assert np.array_equal(track.position_covariances, run.position_covariances)
    assert np.array_equal(track.rotation_covariances, run.rotation_covariances)
    assert np.array_equal(track.nis, run.nis)
    assert np.array_equal(track.events, run.events)
    assert run.position_errors[-1] < 0.1


@pytest.mark.parametrize("scenario", [ROOM, PLANAR], ids=["space", "plane"])
def test_step_by_step_is_the_whole(scenario: Scenario) -> None:
    recording = scenario.simulate()
    whole = recording.track("uc-kf")
    tracker = Tracker(recording, "uc-kf")
    for k in range(recording.epochs):
        step = tracker.step(
            recording.intervals[k],
            recording.squared_ranges[k],
            recording.velocities[k],
            recording.angular_velocities[k],
        )
        assert np.array_equal(step.positions[0], whole.positions[k])
        assert np.array_equal(step.orientations[0], whole.orientations[k])


@pytest.mark.parametrize("name", LOCALIZERS)
def test_localizers_find_the_pose_of_one_epoch(name: str) -> None:
    recording = ROOM.simulate()
    found = recording.localize(name)
    if name == "classical-ls":
        assert found.pose is None
        return
    assert np.linalg.norm(found.position - recording.truth_positions[0]) < 0.1
    assert np.linalg.norm(found.orientation - recording.truth_orientations[0]) < 0.5


def test_arrays_of_ones_own_make_a_recording() -> None:
    recording = ROOM.simulate()
    squared = recording.squared_ranges
    squared[3, 1, 2] = np.nan
    document = recording.to_dict()
    own = Recording.from_arrays(
        anchors=recording.anchors,
        sensors=recording.sensors,
        noise=document["noise"],
        interval=recording.intervals,
        squared_ranges=squared,
        velocity=recording.velocities,
        angular_velocity=recording.angular_velocities,
        initial=document["initial"],
        process=document["process"],
    )
    assert np.array_equal(own.squared_ranges, squared, equal_nan=True)
    assert np.isnan(own.truth_positions).all()
    assert np.array_equal(own.track("kf").positions[:3], recording.track("kf").positions[:3])
    assert not np.array_equal(own.track("kf").positions[3], recording.track("kf").positions[3])
    still = Recording.from_arrays(
        anchors=recording.anchors,
        sensors=recording.sensors,
        noise=document["noise"],
        interval=0.1,
        ranges=np.sqrt(squared),
    )
    assert np.array_equal(still.velocities, np.zeros((60, 3)))
    assert list(still.run().bounds) == ["linear_posterior_crb"]


def test_shapes_in_the_plane() -> None:
    run = PLANAR.run()
    k = len(run.times)
    assert run["kf"].orientations.shape == (k, 2, 2)
    assert run["kf"].positions.shape == (k, 2)
    assert run["kf"].rotation_covariances.shape == (k, 1, 1)
    assert run.bounds["posterior_crb"].rotation_covariances.shape == (k, 1, 1)
    assert PLANAR.localization_cloud(7).shape == (7, len(LOCALIZERS), 3 + 6)


def test_the_field_agrees_with_the_bound_at_its_points() -> None:
    field = ROOM.field(24)
    assert max(field.values.shape) == 24
    for index in ((0, 0), (5, 7), (-1, -1)):
        bound = ROOM.bound_at(field.points[index])["position_sigma"]
        assert field.values[index] == pytest.approx(bound, rel=1e-9)


def test_placement_improves_and_one_more_anchor_helps() -> None:
    better, found = ROOM.improve()
    assert found["after"] < found["before"] == ROOM.advise()["value"]
    assert better.advise()["value"] == pytest.approx(found["after"])
    best = ROOM.best_next()
    assert best is not None
    assert best["after"] < best["before"]
    assert ROOM.next_at(best["point"])["after"] == best["after"]
    curve = ROOM.size_curve([1.0, 2.0])
    assert curve[1] < curve[0]


def test_indoor_filters_run_and_are_averaged() -> None:
    scenario = IndoorScenario.preset()
    run = scenario.run()
    for each in run.filters.values():
        assert each.positions.shape == (100, 3)
        assert each.failure is None
    assert run["mekf"].position_errors[-1] < 1.0
    study = scenario.study(40, threads=2)
    assert study.to_json() == scenario.study(40, threads=1).to_json()
    assert study.curve("mekf", "position").values[0] < 1.0


def test_curves_hold_values_and_standard_errors() -> None:
    study = ROOM.study(40)
    curve = study.curve("uc-kf", "rmse_position")
    steps = study.to_dict()["estimators"][2]["steps"]
    assert np.array_equal(curve.values, [step["rmse_position"]["value"] for step in steps])
    assert np.array_equal(
        curve.standard_errors,
        [step["rmse_position"]["standard_error"] for step in steps],
    )
    bound = study.curve("posterior_crb", "position").values
    assert (curve.values > bound - 4 * curve.standard_errors).all()


def test_scenarios_travel_to_other_processes() -> None:
    assert pickle.loads(pickle.dumps(ROOM)) == ROOM
    recording = ROOM.simulate()
    assert pickle.loads(pickle.dumps(recording)).to_json() == recording.to_json()
    run = recording.run()
    assert pickle.loads(pickle.dumps(run)).to_json() == run.to_json()


def test_frames_hold_every_number() -> None:
    run = ROOM.run()
    pandas, polars = run.to_pandas(), run.to_polars()
    assert len(pandas) == len(polars) == 6 * 60
    kf = pandas[pandas["estimator"] == "kf"]
    assert np.array_equal(kf["position_error_m"], run["kf"].position_errors)
    assert np.array_equal(polars["position_error_m"][:60].to_numpy(), run["kf"].position_errors)
    study = ROOM.study(20)
    assert {"name", "step", "rmse_position", "rmse_position_standard_error"} <= set(study.to_pandas().columns)
    assert study.to_polars().height == len(study.rows())


def test_what_a_notebook_shows() -> None:
    shown = [
        ROOM,
        ROOM.simulate(),
        ROOM.run(),
        ROOM.study(20),
        IndoorScenario.preset(),
        rangelab.figure("tracking-2", 20),
    ]
    for each in shown:
        html = each._repr_html_()  # type: ignore[attr-defined]
        assert html.count("<table>") == html.count("</table>") == 1
        assert repr(each).startswith("<rangelab.")
