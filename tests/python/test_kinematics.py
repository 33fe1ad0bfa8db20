"""Relative kinematics: every estimator by name, its bits, the bound, studies, and what is refused."""

import math
import pickle
import re
from collections.abc import Callable

import numpy as np
import pytest
import rangelab
from conftest import ROOT, fingerprint
from rangelab import DistanceRecord, KinematicsScenario, RelativeKinematics

PAPER = KinematicsScenario.preset()
SPARSE = KinematicsScenario.preset("kinematics-sparse")
NAMES = [name for name, _, _ in rangelab.kinematics_estimators()]
PRESETS = [preset["name"] for preset in rangelab.kinematics_presets()]


def numbers_of_golden(part: rangelab.KinematicsEstimatorRun) -> bytes:
    """The numbers of an estimator in the order of `tests/golden/kinematics.rs`."""
    snapshots = part.snapshots[~np.isnan(part.snapshots).any(axis=(1, 2))]
    margin = -1.0 if part.acceleration_margin is None else part.acceleration_margin
    last = np.asarray([margin, part.iterations, len((part.failure or "").encode())], dtype=np.float64)
    errors = [part.coefficient_errors, part.gram_errors, part.position_errors, part.aligned_position_errors]
    return b"".join(np.ravel(each).astype("<f8").tobytes() for each in [part.coefficients, *errors, snapshots, last])


@pytest.mark.parametrize("preset", PRESETS)
def test_every_estimator_gives_the_bits_of_the_crate_and_of_the_page(preset: str) -> None:
    lines = (ROOT / "tests/golden/kinematics.txt").read_text().splitlines()
    run = KinematicsScenario.preset(preset).replace({"estimators.enabled": NAMES}).run()
    found = [f"{fingerprint(run.truth.astype('<f8').tobytes())} {preset} truth"]
    found += [f"{fingerprint(numbers_of_golden(run[name]))} {preset} {name}" for name in NAMES]
    assert found == [line for line in lines if line.split()[1] == preset]
    # One bit less in one number would be seen.
    spoiled = run.truth.copy()
    spoiled[0, 0, 0] = np.nextafter(spoiled[0, 0, 0], 0.0)
    assert fingerprint(spoiled.astype("<f8").tobytes()) != found[0].split()[0]


@pytest.mark.parametrize("name", NAMES)
def test_an_estimator_alone_is_that_of_the_run(name: str) -> None:
    part = PAPER.replace({"estimators.enabled": [name]}).run(2)[name]
    simulated = PAPER.simulate(2)
    found = simulated.record.estimate(name)
    if found.motion is None:
        assert len(part.coefficients) == 0
        assert (found.snapshots.shape == (100, 10, 2)) == (name == "multidimensional-scaling")
    else:
        assert np.array_equal(found.motion.aligned_to(simulated.truth).coefficients, part.coefficients)
        assert found.motion.coefficients.shape == (3, 10, 2)
    assert found.iterations == part.iterations
    assert found.acceleration_margin == part.acceleration_margin
    assert found.rotation is None or np.allclose(found.rotation.T @ found.rotation, np.eye(2))


def test_an_estimator_finds_the_motion_and_accelerations_are_in_the_stated_frame() -> None:
    simulated = PAPER.simulate()
    record, truth = simulated.record, simulated.truth
    motion = record.estimate("maximum-likelihood").motion
    assert motion is not None
    errors = motion.aligned_to(truth).coefficients - truth.coefficients
    assert np.sqrt(np.mean(errors[1] ** 2)) < 5 * PAPER.bound().coefficient_rmse(1)
    positions = truth.positions(record.stamps)
    distances = np.linalg.norm(positions[:, :, None] - positions[:, None, :], axis=-1)
    assert np.abs(record.distances - distances).max() < 6 * record.sigma
    assert record.accelerations is not None
    # The readings are not centred, and turned into the frame of the accelerometers.
    exact = PAPER.motion.derivative(2, record.stamps) @ simulated.sensor_from_world.T
    assert np.abs(record.accelerations - exact).max() < 6 * 0.001
    assert np.abs(record.accelerations - PAPER.motion.derivative(2, record.stamps)).max() > 0.1


def test_arrays_of_ones_own_make_a_record() -> None:
    record = SPARSE.simulate(1).record
    own = DistanceRecord(
        record.stamps,
        record.distances,
        sigma=record.sigma,
        accelerations=record.accelerations,
        sigma_acceleration=0.001,
    )
    name = "maximum-likelihood-accelerometers"
    assert own.estimate(name).cost == record.estimate(name).cost
    with pytest.raises(rangelab.Error, match="acceler"):
        own.without_accelerations().estimate("algorithm-2-so")
    missing = record.distances.copy()
    missing[4, 0, 3] = np.nan
    lost = DistanceRecord(record.stamps, missing, sigma=record.sigma)
    assert np.argwhere(np.isnan(lost.distances)).tolist() == [[4, 0, 3], [4, 3, 0]]
    snapshots = lost.estimate("multidimensional-scaling").snapshots
    assert np.isnan(snapshots[4]).all()
    assert np.isfinite(snapshots[5]).all()


def test_motions_are_polynomials_of_time() -> None:
    motion = RelativeKinematics([[[0, 0], [2, 4]], [[1, 0], [0, 0]], [[0, 2], [0, 0]]])
    assert motion.positions([0.0, 3.0]).tolist() == [[[0, 0], [2, 4]], [[3, 9], [2, 4]]]
    assert motion.derivative(1, 3.0).tolist() == [[[1, 6], [0, 0]]]
    gram = sum(b * 3.0**power for power, b in enumerate(motion.gram))
    assert np.allclose(gram, motion.positions(3.0)[0] @ motion.positions(3.0)[0].T)
    assert np.allclose(motion.centred().coefficients.mean(axis=1), 0.0)


def test_the_bound_is_that_of_studies_and_holds() -> None:
    study = PAPER.replace(steps=5).study(40)
    for part in study.to_dict()["bounds"]:
        bound = PAPER.bound(part["accelerations"])
        assert [bound.coefficient_rmse(order) for order in range(3)] == part["coefficients"]
        assert [bound.gram_rmse(order) for order in range(3)] == part["gram"]
        instants = study.to_dict()["instants"]
        assert bound.position_rmse(instants).tolist() == part["positions"]
        assert bound.position_rmse(instants, at_each=True).tolist() == part["aligned_positions"]
        covariance = bound.coefficient_covariance(1)
        assert covariance.shape == (20, 20)
        assert math.sqrt(np.trace(covariance) / 20) == pytest.approx(bound.coefficient_rmse(1), rel=1e-12)
        assert bound.position_covariance(1.0).shape == (20, 20)
    curve = study.curve("maximum-likelihood", "coefficients")
    bounds = study.curve("CRB, distances", "coefficients").values
    assert (np.abs(curve.values - bounds) < 4 * curve.standard_errors + 0.01 * bounds).all()
    assert study.curve("maximum-likelihood", "positions").values.shape == (5,)
    with pytest.raises(rangelab.UnknownName, match="coefficients"):
        study.curve("maximum-likelihood", "beauty")


def test_studies_have_the_bits_of_their_trials_on_any_number_of_threads() -> None:
    scenario = SPARSE.replace({"estimators.enabled": ["algorithm-1-rank1", "snapshot-sync"]})
    study = scenario.study(45, threads=3)
    assert study.to_json() == scenario.study(45, threads=1).to_json()
    runs = [scenario.run(trial) for trial in range(45)]
    for part in study.to_dict()["estimators"]:
        errors = sorted(run[part["name"]].coefficient_errors[1] for run in runs)
        assert part["summary"]["velocity_distribution"] == errors


def test_runs_studies_and_figures_are_those_of_the_command_line(cli: Callable[..., str]) -> None:
    def said(*arguments: str) -> str:
        return cli(*arguments, "--format", "json").strip()

    assert SPARSE.run(3).to_json() == said("anchorless", "run", "kinematics-sparse", "--trial", "3")
    study = SPARSE.study(25, threads=2)
    assert study.to_json() == said("anchorless", "study", "kinematics-sparse", "--trials", "25")
    figure = rangelab.figure("kinematics-1", 2, seed=5)
    assert figure.to_json().strip() == said("figure", "kinematics-1", "--trials", "2", "--seed", "5")


def test_a_study_tells_its_progress_and_stops_when_asked() -> None:
    scenario = SPARSE.replace({"estimators.enabled": ["algorithm-1-rank1"]}, steps=2)
    heard: list[tuple[int, int]] = []
    scenario.study(45, progress=lambda done, total: heard.append((done, total)))
    assert heard == [(0, 45), (20, 45), (40, 45), (45, 45)]
    half = scenario.study(45, progress=lambda done, _: done < 20)
    assert (half.trials, half.asked) == (20, 45)
    with pytest.raises(rangelab.Cancelled):
        scenario.study(45, progress=lambda done, total: False)


def test_every_problem_of_a_scenario_is_listed() -> None:
    spoiled = {"noise.sigma_distance": -1.0, "estimators.degree": 9, "steps": 0}
    with pytest.raises(rangelab.InvalidDocument, match=r"estimators\.degree is 9") as caught:
        PAPER.replace(spoiled)
    assert sorted(path for path, _, _ in caught.value.problems) == sorted(spoiled)


TABLE = np.ones((1, 3, 3))


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: KinematicsScenario.preset("nowhere"), "no kinematics preset is called"),
        (lambda: KinematicsScenario({"version": 1, "coefficients": []}), "coefficients"),
        (lambda: SPARSE.run()["guess"], "there are: algorithm-1-rank1"),
        (lambda: SPARSE.simulate().record.estimate("guess"), "there are|snapshot-sync"),
        (lambda: SPARSE.simulate().record.estimate(degree=9), "degree is 9, allowed: 0 to 8"),
        (lambda: SPARSE.simulate().record.estimate(degree=-1), "cannot be read"),
        (lambda: SPARSE.replace({"noise.sigma_distance": 0.0}).bound(), "standard deviation"),
        (lambda: SPARSE.bound().coefficient_rmse(3), "coefficients of the motion"),
        (lambda: SPARSE.study(0), "number of trials"),
        (lambda: DistanceRecord([0.0], np.ones((2, 3, 3)), sigma=0.1), r"\(K, N, N\)"),
        (lambda: DistanceRecord([0.0], TABLE, sigma=-1.0), "not negative"),
        (lambda: DistanceRecord([0.0], TABLE, sigma=0.1, dimension=4), "2 or 3"),
        (lambda: DistanceRecord([0.0], TABLE, sigma=0.1).estimate(), "needs at least"),
        (lambda: DistanceRecord([], np.ones((0, 3, 3)), sigma=0.1).estimate(), "needs at least"),
        (lambda: DistanceRecord([0.0], np.ones((1, 0, 0)), sigma=0.1).estimate(), "needs at least"),
        (lambda: DistanceRecord([0.0], TABLE * math.inf, sigma=0.1), "finite"),
        (lambda: DistanceRecord([0.0], TABLE, sigma=0.1, accelerations=[[1.0]]), "K x N x D"),
        (lambda: DistanceRecord([0.0], TABLE, sigma=0.1, accelerations=np.ones((1, 4, 2))), "accelerations"),
        (lambda: RelativeKinematics([1.0]), "N x D"),
        (lambda: RelativeKinematics(np.ones((0, 3, 2))), "coefficients"),
        (lambda: RelativeKinematics([[[math.nan, 0.0]]]), "finite"),
        (lambda: RelativeKinematics(np.ones((1, 3, 3))).aligned_to(PAPER.motion), "are needed"),
        (
            lambda: RelativeKinematics(np.ones((1, 3, 4))).aligned_to(RelativeKinematics(np.ones((1, 3, 4)))),
            "dimension",
        ),
        (lambda: rangelab.Scenario.preset("room").anchor_draws(0), "number of trials"),
        (lambda: rangelab.Scenario.preset("room").anchor_draws(1).angles("guess"), "there are: posterior_crb"),
    ],
)
def test_bad_data_is_a_sentence(make: Callable[[], object], words: str) -> None:
    with pytest.raises(rangelab.Error, match=words):
        make()


def test_what_travels_and_what_a_notebook_shows() -> None:
    simulated, run = SPARSE.simulate(), SPARSE.run()
    assert KinematicsScenario(SPARSE.to_dict()) == pickle.loads(pickle.dumps(SPARSE))
    assert pickle.loads(pickle.dumps(run)).to_json() == run.to_json()
    restored = pickle.loads(pickle.dumps(simulated.record))
    assert restored.estimate().cost == simulated.record.estimate().cost
    readings = simulated.record.accelerations
    assert readings is not None
    assert np.array_equal(readings, restored.accelerations)
    assert np.array_equal(pickle.loads(pickle.dumps(simulated.truth)).coefficients, simulated.truth.coefficients)
    study = SPARSE.replace(steps=3).study(20)
    assert study.to_polars().height == len(study.rows()) == len(study.to_pandas())
    for shown in (SPARSE, run, study):
        assert shown._repr_html_().count("<table>") == 1
    for each in (SPARSE, run, study, simulated.record, simulated.truth, simulated.record.estimate()):
        assert re.match(r"<rangelab\.\w+", repr(each))


def test_draws_of_anchors_are_trials_with_fixed_and_with_new_anchors() -> None:
    scenario = rangelab.Scenario.preset("tracking-paper").replace({"estimators.enabled": ["kf", "uc-kf"]}, steps=8)
    heard: list[tuple[int, int]] = []
    draws = scenario.anchor_draws(25, threads=2, progress=lambda done, total: heard.append((done, total)))
    assert heard == [(0, 25), (20, 25), (25, 25)]
    assert draws.numbers.shape == (25, 2, 7)
    for trial in (0, 24):
        run = scenario.run(trial)
        for name in ("kf", "uc-kf"):
            expected = np.sqrt(np.mean(run[name].orientation_errors ** 2))
            assert draws.angles(name)[trial, 0] == pytest.approx(expected, rel=1e-12)
            expected = np.sqrt(np.mean(run[name].position_errors ** 2))
            assert draws.positions(name)[trial, 0] == pytest.approx(expected, rel=1e-12)
        bound = np.sqrt(np.mean(run.bounds["posterior_crb"].position ** 2))
        assert draws.positions("posterior_crb")[trial, 0] == pytest.approx(bound, rel=1e-12)
    fixed, redrawn = draws.conditions.T
    assert np.ptp(fixed) < 0.5 * np.ptp(redrawn)
    assert draws.half_width == np.abs(scenario.anchors).max()
    assert scenario.anchor_draws(20).numbers.tobytes() == draws.numbers[:20].tobytes()
