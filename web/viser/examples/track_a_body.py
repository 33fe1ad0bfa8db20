"""Ranges of your own, step by step, then the same body against its bound over many trials."""

import numpy as np
from numpy.typing import NDArray
from rangelab import Recording, Scenario, Study, Tracker


def ranges_of_your_own() -> Recording:
    """Here they are simulated; any K x M x N array of ranges in metres does, NaN where one is missing."""
    simulated = Scenario.preset("room").simulate()
    return Recording.from_arrays(
        anchors=simulated.anchors,
        sensors=simulated.sensors,
        noise={"kind": "range", "sigma": 0.01},
        interval=simulated.intervals,
        ranges=np.sqrt(simulated.squared_ranges),
        velocity=simulated.velocities,
        angular_velocity=simulated.angular_velocities,
    )


def followed(recording: Recording) -> NDArray[np.float64]:
    """Positions (K x 3, m) as the ranges come in."""
    tracker = Tracker(recording, "uc-kf")
    steps = [
        tracker.step(float(interval), ranges, velocity, turning)
        for interval, ranges, velocity, turning in zip(
            recording.intervals,
            recording.squared_ranges,
            recording.velocities,
            recording.angular_velocities,
            strict=True,
        )
    ]
    return np.concatenate([step.positions for step in steps])


def averaged(trials: int) -> Study:
    """Errors and bounds over many trials, each with its standard error."""
    return Scenario.preset("room").study(trials, progress=lambda done, total: done <= total)


def main() -> None:
    """Prints where the body is, and how near the bound the UC-KF comes."""
    positions = followed(ranges_of_your_own())
    print(f"last position: {np.round(positions[-1], 3)} m")
    study = averaged(200)
    error, bound = study.curve("uc-kf", "rmse_position"), study.curve("posterior_crb", "position")
    ratio = error.values[-1] / bound.values[-1]
    print(f"UC-KF: {1e3 * error.values[-1]:.2f} mm, {ratio:.2f} times the bound")


if __name__ == "__main__":
    main()
