"""What is told of a run of trackers and of averages, and beside controls: the page's words with the crate's numbers."""

import re
from typing import Any

import numpy as np
import pytest
from rangelab import Run, Scenario, chi_squared_interval, presets
from rangelab.view.labs import computed, lab_of
from rangelab.view.labs import track_cautions as cautions
from rangelab.view.labs.averages import Averages
from rangelab.view.labs.track_averages import averaged_readout
from rangelab.view.labs.track_findings import told_at
from rangelab.view.labs.track_verdicts import Means, outside
from rangelab.view.picture import Wish
from rangelab.view.readout import reading
from viewer_client import until
from viewer_labs import shown

DEGREES = float(np.degrees(1.0))
ROOM = Scenario.preset("room")
STEPS, TRIALS = 20, 100


class Changed:
    """An estimator with other numbers."""

    def __init__(self, of: Any, **parts: Any) -> None:
        self.__dict__.update(parts)
        self._of = of

    def __getattr__(self, name: str) -> Any:
        return getattr(self._of, name)


def changed(run: Run, name: str, **parts: Any) -> Run:
    """The run with other numbers of an estimator."""
    estimators: dict[str, Any] = run.estimators
    estimators[name] = Changed(run[name], **parts)
    return run


def room() -> Run:
    """A run of its own."""
    return ROOM.run()


@pytest.mark.parametrize("name", [each["name"] for each in presets()])
def test_every_step_of_every_preset_is_told_without_holes(name: str) -> None:
    run = Scenario.preset(name).run()
    for step in range(len(run.times)):
        text = told_at(run, step)
        assert re.match(r"^[A-Z0-9x-z].*\.$", text), (step, text)
        assert not re.search(r"nan|inf|None|–|\|\|", text), (step, text)


@pytest.mark.parametrize("step", [5, 30, 59])
def test_the_nearest_is_named_with_its_error_and_bound(step: int) -> None:
    run = room()
    best = min(run.estimators.values(), key=lambda each: np.square(each.orientation_errors[: step + 1]).sum())
    bound = run.bounds["posterior_crb_raw" if best.name == "eskf-raw" else "posterior_crb"]
    degrees = reading(DEGREES * best.orientation_errors[step])
    expected = (
        f"{best.label}, {degrees}° and {reading(best.position_errors[step])} m off; "
        f"the bound is {reading(DEGREES * bound.orientation[step])}° and {reading(bound.position[step])} m."
    )
    assert expected in told_at(run, step)


def test_projections_are_counted_up_to_the_step() -> None:
    run = Scenario.preset("coplanar-ceiling").run()
    events, last = run["et-kf"].events, len(run.times) - 1
    assert events[:41].sum() < events.sum()
    assert f"ET-KF projected at {events[:41].sum()} of 41 steps so far." in told_at(run, 40)
    assert f"ET-KF projected at {events.sum()} of {last + 1} steps." in told_at(run, last)


def test_under_a_ceiling_height_is_weak_and_the_plane_is_why() -> None:
    run = Scenario.preset("coplanar-ceiling").run()
    variances = np.linalg.eigvalsh(run.bounds["posterior_crb"].position_covariances[-1])
    ratio = float(f"{np.sqrt(variances[2] / variances[:2].mean()):.2g}")
    assert ratio > 5
    thickness = run.geometry["anchors"]["plane"]["thickness"]
    expected = (
        f"Five anchors lie within {reading(thickness)} m of one plane: "
        f"height is known {ratio:g} times worse than position in it."
    )
    assert expected in told_at(run, len(run.times) - 1)
    assert not re.search("anchors|worse", told_at(room(), 59))


def test_anchors_on_a_wall_of_the_plane_make_the_other_coordinate_weak() -> None:
    planar = Scenario.preset("planar")
    anchors = [[x + index, 0.01 * index] for index, (x, _) in enumerate(planar.anchors.tolist())]
    run = planar.replace(anchors=anchors).run()
    told = told_at(run, len(run.times) - 1)
    assert re.search(r"Four anchors lie within .* m of one line: y is known .* worse than position along it\.", told)


def test_what_cannot_be_seen_is_said_by_the_crate() -> None:
    run = Scenario.preset("three-anchors").run()
    assert run.unseen is not None
    assert run.unseen.replace("||s||^2", "‖s‖²")[:60] in told_at(run, 20)


def test_errors_beyond_the_covariance_are_told_with_the_worst() -> None:
    least, most = chi_squared_interval(12, 0.998)
    for nees, word in ((most + 1, "KF is over-confident: NEES "), (least - 0.1, "KF knows more than claimed: NEES ")):
        assert f"{word}{reading(nees)}" in told_at(changed(room(), "kf", nees=np.full(60, nees)), 10)
    for nees in (least + 0.01, most - 0.01):
        assert "NEES" not in told_at(changed(room(), "kf", nees=np.full(60, nees)), 10)
    both = changed(changed(room(), "kf", nees=np.full(60, most + 1)), "ortho", nees=np.full(60, 400.0))
    assert "KF and KF-ortho are over-confident: NEES up to 400" in told_at(both, 10)


def test_ranges_that_surprise_are_told_from_the_second_step_on() -> None:
    run = changed(room(), "kf", nis=np.full(60, 100.0))
    most = chi_squared_interval(25, 0.998)[1]
    expected = f"The ranges surprise KF: NIS 100, where {reading(most)} is rarely passed."
    assert expected in told_at(run, 10)
    assert "surprise" not in told_at(run, 0)


def test_an_estimator_that_stopped_or_mirrors_comes_first() -> None:
    stopped = changed(room(), "uc-kf", failure=(7, "The ranges ran out"))
    assert told_at(stopped, 7).startswith("UC-KF stopped at step 8: The ranges ran out. ")
    assert "stopped" not in told_at(stopped, 6)
    mirrored = changed(room(), "kf", orientations=np.tile(np.diag([1.0, 1.0, -1.0]), (60, 1, 1)))
    assert told_at(mirrored, 9).startswith("KF reports a mirrored body: det Q < 0. ")


def test_the_sentence_follows_the_step() -> None:
    with shown(ROOM) as (_, client):
        client.set(client.control("step"), 9)
        expected = told_at(ROOM.run(), 9).split(". ")[0]
        until(lambda: any(expected in str(m["updates"].get("content")) for m in client.of_type("GuiUpdateMessage")))


def means(label: str, value: float, failures: int = 0) -> Means:
    """Of a filter that is as much off at each step."""
    return Means(label, np.full(STEPS, value), np.full(STEPS, 6.0), np.full(STEPS, TRIALS - failures))


def test_only_filters_beyond_chance_are_spoken_of() -> None:
    assert outside("NEES", [means("KF", 1.0), means("UC-KF", 1.05)]) == ""
    assert outside("NEES", []) == ""
    told = outside("NEES", [means("KF", 1.0), means("UC-KF", 1.8)])
    assert re.fullmatch(r"UC-KF is too sure of itself: mean NEES up to 1\.80 \(by chance 1\.[2-4]\d\)\.", told)
    assert outside("NEES", [means(name, 3.0) for name in "ABC"]).startswith("All filters are too sure of themselves")
    told = outside("NEES", [means("KF", 0.5), means("UC-KF", 1.0)])
    assert told.startswith("KF knows more than it claims: mean NEES down to 0.500")
    assert outside("NEES", [means("KF", 0.5), means("UC-KF", 2.0)]).startswith("UC-KF is too sure")


def test_trials_that_failed_do_not_count() -> None:
    assert outside("NEES", [means("KF", 1.35)])
    assert not outside("NEES", [means("KF", 1.35, failures=90)])


def test_the_confident_filter_is_found_out_by_its_averages() -> None:
    def told(name: str) -> str:
        scenario = Scenario.preset(name)
        found = computed(Wish(scenario, lab_of(scenario), study=scenario.study(60)))
        return found.readout(3).told

    assert re.search("too sure .* NEES .*too sure .* NIS", told("overconfident"))
    lone = ROOM.replace({"estimators.enabled": ["eskf", "eskf-raw"]})
    assert averaged_readout(Averages(lone.study(60)), 3, [], []).told == "NEES and NIS stay within what chance allows."


PLAIN: dict[str, Any] = (
    Scenario.preset("planar")
    .replace(
        {
            "interval": 0.5,
            "motion.sigma_omega": 0.2,
            "motion.sigma_t": 0.03,
            "process": {"sigma_q": 0.1, "sigma_t": 0.03},
            "start.position": [3, 4],
            "sensors": [[-1, 0], [1, 0], [0, 1], [0, -1]],
            "initial": {"orientation": [[1, 0], [0, 1]], "position": [0, 0], "covariance": 4.0},
            "estimators.threshold": {"kind": "absolute", "epsilon": 0.1},
        }
    )
    .to_dict()
)
SETTINGS = (
    cautions.on_manifold,
    cautions.on_feedback,
    cautions.on_decoupling,
    cautions.on_weights,
    cautions.on_threshold,
    cautions.on_prior,
    cautions.on_process_noise,
    cautions.on_guess,
    cautions.on_zero_threshold,
)


def but(**changes: Any) -> dict[str, Any]:
    """The plain document with other entries, or other settings of estimators."""
    settings = {key: value for key, value in changes.items() if key in PLAIN["estimators"]}
    rest = {key: value for key, value in changes.items() if key not in settings}
    return PLAIN | {"estimators": PLAIN["estimators"] | settings} | rest


def test_the_usual_choices_are_no_reason_for_a_warning() -> None:
    assert not [told for told in (say(PLAIN) for say in SETTINGS) if told.startswith(cautions.WARNING)]


def test_each_dangerous_choice_is_warned_of() -> None:
    shifted = [[x + 0.3, y] for x, y in PLAIN["sensors"]]
    initial = PLAIN["initial"]
    for told, word in (
        (cautions.on_manifold(but(manifold="o")), "mirrored"),
        (cautions.on_feedback(but(feedback=True)), "NEES"),
        (cautions.on_weights(but(weights="true")), "cheating"),
        (cautions.on_threshold(but(threshold={"kind": "relative", "epsilon": 1.0})), "shrinks"),
        (cautions.on_decoupling(but(decoupled=True, sensors=shifted)), "0.300 m"),
        (cautions.on_weighting(PLAIN, 2.0), "50.0 %"),
        (cautions.on_prior(but(initial=initial | {"covariance": 1.0})), "5.00 m away"),
        (cautions.on_prior(but(initial=initial | {"covariance": 9.0})), "± 122°"),
        (cautions.on_guess(but(initial=initial | {"orientation": [[1, 0], [0, 2]]})), "= 3.00"),
    ):
        assert told.startswith(cautions.WARNING), told
        assert word in told
    assert not cautions.on_weighting(PLAIN, 100.0).startswith(cautions.WARNING)
    assert cautions.on_decoupling(but(decoupled=True)).startswith("Exact")
    assert "every step" in cautions.on_zero_threshold(but(threshold={"kind": "absolute", "epsilon": 0.0}))


def test_process_noise_is_compared_with_what_disturbs_the_body_in_one_step() -> None:
    def assuming(sigma_q: float, sigma_t: float) -> str:
        return cautions.on_process_noise(but(process={"sigma_q": sigma_q, "sigma_t": sigma_t}))

    lag = "Orientation: 10.0 times too little, so the filters trust their prediction and lag."
    assert assuming(0.01, 0.03) == cautions.WARNING + lag
    assert "Position: 20.0 times too much" in assuming(0.1, 0.6)
    assert re.search("Orientation: none assumed.*Position: none assumed", assuming(0, 0))


def test_why_the_linear_bound_lies_below() -> None:
    run = room()
    below = cautions.on_linear_bound(run)
    angles = [reading(DEGREES * run.bounds[name].orientation[-1]) for name in ("linear_posterior_crb", "posterior_crb")]
    assert f"{angles[0]}°, lies below the intrinsic one, {angles[1]}°" in below
