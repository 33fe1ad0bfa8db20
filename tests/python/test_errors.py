"""Bad data is an exception with the sentence of the other doors; nothing ends the interpreter."""

import json
import subprocess
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
import rangelab
from conftest import ROOT
from rangelab import IndoorScenario, Recording, Scenario, _core

ROOM = Scenario.preset("room")


def test_every_problem_is_listed_with_path_value_and_limit(
    cli: Callable[..., str],
) -> None:
    spoiled = {**ROOM.to_dict(), "steps": 0, "noise": {"kind": "range", "sigma": -1}}
    with pytest.raises(rangelab.InvalidDocument) as caught:
        Scenario(spoiled)
    assert [path for path, _, _ in caught.value.problems] == ["noise.sigma", "steps"]
    text = str(caught.value)
    # The command line says the same.
    command = [str(ROOT / "target/debug/rangelab"), "run", "-"]

    done = subprocess.run(command, input=json.dumps(spoiled), capture_output=True, text=True)
    assert done.returncode != 0
    for path, value, limit in caught.value.problems:
        assert f"{path} is {value}, allowed: {limit}" in text
        assert path in done.stderr


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Scenario("{"), "cannot be read"),
        (lambda: Scenario({**ROOM.to_dict(), "version": 2}), "newer"),
        (lambda: Scenario({**ROOM.to_dict(), "surprise": 1}), "surprise"),
        (lambda: Scenario({**ROOM.to_dict(), "steps": float("nan")}), "steps is nan"),
        (lambda: Scenario({**ROOM.to_dict(), "anchors": {1}}), "anchors is a set"),
        (
            lambda: ROOM.replace({"noise.nothing.here": 1}),
            "nothing at noise.nothing.here",
        ),
        (lambda: Scenario.preset("nowhere"), "no preset is called"),
        (lambda: IndoorScenario.preset("nowhere"), "nowhere"),
        (lambda: rangelab.figure("tracking-9"), "tracking-2"),
        (lambda: ROOM.simulate().track("kalman"), "no estimator is called"),
        (lambda: ROOM.simulate().localize("guess"), "no localizer is called"),
        (lambda: ROOM.simulate().localize(epoch=99), "epoch"),
        (
            lambda: ROOM.simulate().localize(settings={"loss": {"kind": "huber", "scale": -1}}),
            "scale is -1",
        ),
        (lambda: ROOM.run()["kalman"], "there are: kf"),
        (lambda: ROOM.study(0), "number of trials"),
        (lambda: ROOM.study(20).curve("kf", "beauty"), "there are: rmse_orientation"),
        (lambda: ROOM.bound_at([0.0]), "coordinates of the point"),
        (lambda: ROOM.field(0), "resolution"),
        (
            lambda: Recording.from_arrays(anchors=[[0, 0]], sensors=[[0, 0]], noise={}, interval=1),
            "one of the two",
        ),
    ],
)
def test_bad_data_is_a_sentence(make: Callable[[], object], words: str) -> None:
    with pytest.raises(rangelab.Error, match=words):
        make()


def test_a_pose_that_is_not_seen_says_why() -> None:
    with pytest.raises(rangelab.Unobservable, match="not enough"):
        Scenario.preset("rod").simulate().localize("ls")


def test_arrays_of_the_wrong_shape_are_named() -> None:
    tracker = rangelab.Tracker(ROOM.simulate())
    with pytest.raises(rangelab.Error, match=r"\[2, 2\] where \[6, 5\] is needed"):
        tracker.step(1.0, np.zeros((2, 2)))


def test_a_panic_is_an_exception_and_the_interpreter_lives() -> None:
    with pytest.raises(rangelab.InternalError, match="on purpose"):
        _core._panic_on_purpose()
    with ThreadPoolExecutor(2) as pool, pytest.raises(rangelab.InternalError):
        pool.submit(_core._panic_on_purpose).result()
    assert ROOM.run()["kf"].failure is None


def test_other_threads_run_meanwhile() -> None:
    ticks: list[float] = []
    ended = threading.Event()

    def tick() -> None:
        while not ended.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)

    ticking = threading.Thread(target=tick)
    plan = _core.Plan.track(ROOM._core, 20)
    ticking.start()
    start = time.monotonic()
    for _ in range(4):
        plan.job(0)
    end = time.monotonic()
    ended.set()
    ticking.join()
    assert sum(start < t < end for t in ticks) > 100 * (end - start)


def test_a_study_tells_its_progress_and_stops_when_asked() -> None:
    heard: list[tuple[int, int]] = []
    whole = ROOM.replace(steps=2).study(50, progress=lambda done, total: heard.append((done, total)))
    assert heard == [(0, 50), (20, 50), (40, 50), (50, 50)]
    half = ROOM.replace(steps=2).study(50, progress=lambda done, _: done < 20)
    assert (whole.trials, half.trials, half.asked) == (50, 20, 50)
    assert half.to_dict()["estimators"] == ROOM.replace(steps=2).study(20).to_dict()["estimators"]
    with pytest.raises(rangelab.Cancelled):
        ROOM.study(50, progress=lambda done, total: False)


def test_what_progress_raises_comes_out() -> None:
    def fail(done: int, _: int) -> None:
        if done:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        ROOM.study(200, progress=fail)
