"""Sweeps: the same numbers on any number of workers, through lost workers and ended sweeps."""

import os
import signal
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet as parquet
import pytest
import rangelab
from rangelab import IndoorScenario, KinematicsScenario, Scenario
from rangelab.sweep import Sweep, sweep

ROOM = Scenario.preset("room").replace({"steps": 5, "estimators.enabled": ["kf", "uc-kf"]})
GRID = {"noise.sigma": [0.01, 0.05], "missing_probability": [0.0, 0.2]}


@pytest.fixture(scope="module")
def alone() -> Sweep:
    """One thread, one chunk after the other."""
    return sweep(ROOM, GRID, 130, on=1, trials_per_chunk=40)


def test_every_point_is_the_study_of_its_scenario(alone: Sweep) -> None:
    point = {"noise.sigma": 0.05, "missing_probability": 0.2}
    rows = [row for row in alone.rows if all(row[key] == value for key, value in point.items())]
    study = ROOM.replace(point).study(130)
    assert [{key: value for key, value in row.items() if key not in point} for row in rows] == study.rows()
    assert len(alone.rows) == 4 * len(study.rows())
    worse = ROOM.replace(point).study(129)
    assert worse.rows() != study.rows()


@pytest.mark.parametrize(("on", "size"), [(3, 20), (2, 1000), (None, 60)])
def test_threads_and_chunks_change_no_bit(alone: Sweep, on: int | None, size: int) -> None:
    assert sweep(ROOM, GRID, 130, on=on, trials_per_chunk=size).rows == alone.rows


def test_a_sweep_that_was_ended_goes_on(alone: Sweep, tmp_path: Path) -> None:
    with pytest.raises(rangelab.Cancelled, match="of 520 trials"):
        sweep(ROOM, GRID, 130, on=1, folder=tmp_path, trials_per_chunk=40, progress=lambda done, _: done < 200)
    kept = {path: path.stat().st_mtime_ns for path in tmp_path.glob("*.npy")}
    assert 3 < len(kept) < 16
    heard: list[int] = []
    again = sweep(
        ROOM, GRID, 130, on=2, folder=tmp_path, trials_per_chunk=40, progress=lambda done, _: heard.append(done)
    )
    assert again.rows == alone.rows
    assert heard[-1] == 520
    assert {path: path.stat().st_mtime_ns for path in kept} == kept
    assert len(list(tmp_path.iterdir())) == 16
    # Another scenario takes none of them.
    other = sweep(ROOM.replace(seed=9), GRID, 130, on=2, folder=tmp_path, trials_per_chunk=40)
    assert other.rows != alone.rows
    assert len(list(tmp_path.iterdir())) == 32


def test_a_lost_or_doubled_chunk_is_refused() -> None:
    from rangelab.sweep.chunks import chunks_of, joined

    chunks = list(chunks_of("track", ROOM, 130, 40))
    numbers = [chunk.run() for chunk in chunks]
    whole = joined("track", ROOM.to_json(), 130, numbers)
    assert whole["trials"] == 130
    for spoiled in (numbers[1:], numbers[:1] + numbers, numbers[:1] + numbers[2:], numbers[::-1]):
        with pytest.raises(rangelab.Error, match="trials before the block"):
            joined("track", ROOM.to_json(), 130, spoiled)


def test_the_table_travels_as_parquet(alone: Sweep, tmp_path: Path) -> None:
    path = tmp_path / "sweep.parquet"
    alone.to_parquet(path)
    back = Sweep.from_parquet(path)
    assert back.about == alone.about
    assert back.about["version"] == rangelab.__version__
    assert Scenario(back.about["scenario"]) == ROOM
    assert back.rows == [{key: value for key, value in row.items() if value is not None} for row in alone.rows]
    table = parquet.read_table(path)
    assert table.num_rows == len(alone.rows)
    assert np.array_equal(alone.to_pandas()["noise.sigma"], table["noise.sigma"].to_numpy())


def test_other_kinds() -> None:
    localize = sweep(ROOM, {"noise.sigma": [0.01, 0.1]}, 60, kind="localize", on=2)
    errors = [row["rmse_position"] for row in localize.rows if row["name"] == "ouc-ls"]
    assert errors[0] < errors[1]
    indoor = sweep(IndoorScenario.preset(), {"ranging.sigma": [0.05, 0.2]}, 20, on=2)
    errors = [row["position"] for row in indoor.rows if row["name"] == "mekf"]
    assert errors[0] < errors[1]
    network = KinematicsScenario.preset("kinematics-sparse").replace(steps=11)
    found = sweep(network, {"noise.sigma_distance": [0.01, 0.1]}, 20, on=2, trials_per_chunk=5)
    expected = network.replace({"noise.sigma_distance": 0.1}).study(20).rows()
    assert found.rows[len(found.rows) // 2 :] == [{"noise.sigma_distance": 0.1, **row} for row in expected]
    assert found.about["kind"] == "kinematics"
    with pytest.raises(rangelab.Error, match="no study of the kind"):
        sweep(ROOM, {}, 20, kind="indoor")
    with pytest.raises(rangelab.Error, match="no study of the kind"):
        sweep(network, {}, 20, kind="track")
    with pytest.raises(rangelab.Error, match="nothing at noise"):
        sweep(ROOM, {"noise.sigmas[0]": [1]}, 20)


def test_a_cluster_that_loses_a_worker_half_way_gives_the_same_numbers(tmp_path: Path) -> None:
    from dask.distributed import Client, LocalCluster

    trials, grid = 400, {"noise.sigma": [0.01, 0.02, 0.05]}
    expected = sweep(ROOM, grid, trials, on=2, trials_per_chunk=20)
    killed: list[int] = []
    heard: list[int] = []
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,  # type: ignore[no-untyped-call]
        Client(cluster) as client,  # type: ignore[no-untyped-call]
    ):
        pids: Any = client.run(os.getpid)
        workers = set(pids.values())
        assert len(workers) == 2

        def kill_half_way(done: int, total: int) -> None:
            heard.append(done)
            if done >= total // 2 and not killed:
                killed.append(min(workers))
                os.kill(killed[0], signal.SIGKILL)

        found = sweep(ROOM, grid, trials, on=client, folder=tmp_path, trials_per_chunk=20, progress=kill_half_way)
    assert killed
    assert found.rows == expected.rows
    assert heard == [20 * (i + 1) for i in range(60)]
    assert len(list(tmp_path.iterdir())) == 60
    _gone(killed[0])


def test_ray_gives_the_same_numbers(alone: Sweep, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RAY_raylet_start_wait_time_s", "300")
    ray = pytest.importorskip("ray", reason="Ray is not installed: pip install 'rangelab[ray]' runs this test")
    ray.init(num_cpus=2, include_dashboard=False, logging_level="ERROR", log_to_driver=False)
    try:
        assert sweep(ROOM, GRID, 130, on="ray", trials_per_chunk=40).rows == alone.rows
    finally:
        ray.shutdown()


def _gone(pid: int) -> None:
    """Waits until a process has ended."""
    ended = threading.Event()
    for _ in range(100):
        try:
            os.kill(pid, 0)
        except ProcessLookupError:
            ended.set()
            break
        time.sleep(0.1)
    assert ended.is_set(), f"process {pid} still runs"
