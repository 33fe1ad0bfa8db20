"""How long a Kalman filter over many recordings takes here and in filterpy, side by side in one run.

`python web/viser/bench/against_filterpy.py` prints the ratio and the overhead of a call (extra `bench`).
"""

import argparse
import time
import timeit
from collections.abc import Callable

import filterpy
import numpy as np
import rangelab
from filterpy.kalman import KalmanFilter
from numpy.typing import NDArray
from rangelab import Recording, Scenario
from scipy.linalg import block_diag

Floats = NDArray[np.float64]

TURN = 20
"""Recordings that one filter goes through before the other does: a slow moment of the machine meets both."""


def linear_model(recording: Recording) -> tuple[Floats, Floats]:
    """`H` and the offsets of `d_mn - d_0n = H theta + offset`, theta = vec([Q | t]): the unknown |s|^2 cancels."""
    anchors, sensors = recording.anchors, recording.sensors
    extended = np.hstack([sensors, np.ones((len(sensors), 1))])
    differences = anchors[1:] - anchors[0]
    H = np.vstack([np.kron(c, -2.0 * differences) for c in extended])
    squares = np.einsum("md,md->m", anchors, anchors)
    return H, np.tile(squares[1:] - squares[0], len(sensors))


Step = tuple[Floats, Floats, Floats, Floats]


def prepared(recording: Recording, offset: Floats, sigma: float) -> list[Step]:
    """What filterpy is given at each step, made beforehand and not timed: `F`, the displacement, `z` and `R`."""
    squared, document = recording.squared_ranges, recording.to_dict()
    motion = zip(recording.intervals, recording.velocities, recording.angular_velocities, squared, strict=True)
    steps = []
    for interval, velocity, turning, ranges in motion:
        F = np.eye(12)
        F[:9, :9] = np.kron(np.eye(3), exponential(interval * turning))
        variances = 4.0 * np.maximum(ranges, 0.0) * sigma**2
        if document["weighting"] == "common":
            variances[:] = variances[:, :1]
        R = block_diag(*(np.diag(column[1:]) + column[0] for column in variances.T))
        z = (ranges[1:] - ranges[0]).T.ravel() - offset
        steps.append((F, np.concatenate([np.zeros(9), interval * velocity]), z, R))
    return steps


def filtered(recording: Recording, steps: list[Step], H: Floats) -> Floats:
    """The positions of filterpy's Kalman filter, K x 3: the same state, ranges, motion and prior."""
    document = recording.to_dict()
    initial, process = document["initial"], document["process"]
    kalman = KalmanFilter(dim_x=12, dim_z=len(H))
    kalman.x = np.concatenate([np.array(initial["orientation"]).T.ravel(), initial["position"]])
    kalman.P = initial["covariance"] * np.eye(12)
    kalman.H = H
    kalman.Q = np.diag([process["sigma_q"] ** 2] * 9 + [process["sigma_t"] ** 2] * 3)
    identity, positions = np.eye(12), []
    for F, displacement, z, R in steps:
        kalman.predict(u=displacement, B=identity, F=F)
        kalman.update(z, R=R)
        positions.append(kalman.x[9:])
    return np.array(positions)


def exponential(phi: Floats) -> Floats:
    """Rodrigues' formula."""
    angle = float(np.linalg.norm(phi)) or 1.0
    x, y, z = phi / angle
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K)


def seconds(work: Callable[[], object]) -> float:
    """Processor time of this thread, which other programs do not lengthen; `timeit` holds the garbage collector."""
    return timeit.timeit(work, timer=time.thread_time, number=1)


def timed(turn: list[tuple[Recording, list[Step]]], H: Floats) -> tuple[float, float]:
    """Seconds of this filter and of filterpy over the same recordings."""
    ours = seconds(lambda: [each.track("kf") for each, _ in turn])
    return ours, seconds(lambda: [filtered(each, steps, H) for each, steps in turn])


def overhead(calls: int = 2000) -> float:
    """Seconds of a call that does nothing but cross over."""
    recording = Scenario.preset("room").simulate()
    return min(seconds(lambda: [recording.dimension for _ in range(calls)]) / calls for _ in range(5))


def compared(weighting: str, count: int, steps: int) -> None:
    """Prints both times, their ratio, and how far the answers lie apart."""
    scenario = Scenario.preset("room").replace({"steps": steps, "weighting": weighting})
    recordings = [scenario.simulate(trial) for trial in range(count)]
    H, offset = linear_model(recordings[0])
    sigma = scenario.to_dict()["noise"]["sigma"]
    given = [(each, prepared(each, offset, sigma)) for each in recordings]
    apart = max(
        float(np.abs(each.track("kf").positions - filtered(each, steps, H)).max()) for each, steps in given[:20]
    )
    turns = [timed(given[begin : begin + TURN], H) for begin in range(0, count, TURN)]
    ours, theirs = (sum(times) for times in zip(*turns, strict=True))
    print(f"{count} recordings of {steps} steps, KF, weighting {weighting}:")
    print(f"  rangelab {1e6 * ours / count / steps:.2f} us a step, filterpy {1e6 * theirs / count / steps:.2f}")
    print(f"  filterpy / rangelab: {theirs / ours:.1f}, positions apart by at most {1e3 * apart:.2g} mm")


def main() -> None:
    """Common weights, which a filter without covariances between coordinates can use, and weights of each pair."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--recordings", type=int, default=1000)
    parser.add_argument("--steps", type=int, default=20)
    options = parser.parse_args()
    print(f"rangelab {rangelab.__version__}, filterpy {filterpy.__version__}, processor time of one thread")
    for weighting in ("common", "per_pair"):
        compared(weighting, options.recordings, options.steps)
    print(f"a call without work: {1e9 * overhead():.0f} ns")


if __name__ == "__main__":
    main()
