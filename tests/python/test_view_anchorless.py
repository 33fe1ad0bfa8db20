"""The Anchorless lab of the viewer: spectra, averages, the sweep over stamps, and what they teach."""

import re
from typing import Any

import numpy as np
from conftest import ROOT
from rangelab import KinematicsScenario
from rangelab.view.labs import anchorless_panel, computed, gauge_panel
from rangelab.view.labs.anchorless_averages import averages
from rangelab.view.labs.anchorless_findings import described, judged
from rangelab.view.labs.anchorless_hints import arrow_seconds
from rangelab.view.labs.anchorless_levels import Report
from rangelab.view.labs.anchorless_panel import on_degree, spread_evenly, with_accelerometers
from rangelab.view.labs.anchorless_spectrum import sizes
from rangelab.view.labs.anchorless_sweep import COUNTS, Sweep, over_stamps, swept
from rangelab.view.picture import Picture, Wish
from rangelab.view.plots import Plot
from rangelab.view.readout import reading
from viewer_client import until
from viewer_labs import shown

PAPER = KinematicsScenario.preset("kinematics-paper")
TRIALS = 20


def picture(scenario: KinematicsScenario, study: Any = None) -> Picture:
    return computed(Wish(scenario, "anchorless", study=study))


def plot(plots: list[Plot], start: str) -> Plot:
    (found,) = [each for each in plots if each.title.startswith(start)]
    return found


def line(found: Plot, label: str) -> Any:
    (each,) = [each for each in found.lines if each.look.label == label]
    return each


def going(_: int, __: int) -> bool:
    return True


def test_the_spectrum_shows_sizes_and_leaves_rounding_out() -> None:
    spectrum, plots = PAPER.gram_spectrum(), picture(PAPER).plots()
    positions, top = plot(plots, "Spectrum: positions, m²"), plot(plots, "Spectrum: accelerations, m²/s⁴")
    assert "2 kept" in positions.axis
    assert positions.x.tolist() == list(range(1, 11))
    epoch = line(positions, "one epoch").values
    assert (np.nanmin(epoch) > 0, spectrum.epoch.min() < 0) == (True, True)
    assert np.isclose(epoch[-1], -spectrum.epoch[-1])
    assert np.isfinite(line(positions, "truth").values).tolist() == [True, True, *[False] * 8]
    assert np.isclose(line(top, "fit of all").values[0], spectrum.fitted_top[0])
    assert np.isnan(sizes(np.array([1.0, 1e-13, -1e-3]))).tolist() == [False, True, False]
    assert not [
        each
        for each in plot(picture(KinematicsScenario.preset("kinematics-missing")).plots(), "Spectrum: p").lines
        if each.look.label == "one epoch"
    ]


def test_what_a_logarithmic_plot_cannot_show_is_not_drawn_at_its_end() -> None:
    with shown(PAPER) as (_, client):
        scales = [message["props"]["scales"]["y"] for message in client.of_type("GuiUplotMessage")]
        assert {(each["distr"], each["clamp"]) for each in scales} == {(3, np.inf)}


def test_numbers_of_millions_have_room_beside_the_axis() -> None:
    assert PAPER.gram_spectrum().fitted.max() > 1e6
    with shown(PAPER) as (_, client):
        until(lambda: len(client.of_type("GuiUplotMessage")) >= 4)
        found = {each["props"]["title"]: each["props"]["axes"][1]["size"] for each in client.of_type("GuiUplotMessage")}
        assert found["Spectrum: positions, m²"] > found["Error, one alignment, m"]


def test_averages_are_those_of_the_report_with_its_bounds() -> None:
    study = averages(PAPER, TRIALS, going)
    report, found = PAPER.study(TRIALS).to_dict(), picture(PAPER, study)
    (summary,) = [each["summary"] for each in report["estimators"] if each["name"] == "maximum-likelihood"]
    for start, of in (("RMSE, one", "positions"), ("RMSE, aligned", "aligned_positions")):
        each = line(plot(found.plots(), start), "ML, distances")
        assert np.allclose(each.values, [step["value"] for step in summary[of]])
        assert np.allclose(each.spread, [2 * step["standard_error"] for step in summary[of]])
        bound = next(each for each in report["bounds"] if not each["accelerations"])
        assert np.allclose(line(plot(found.plots(), start), "CRB, distances").values, bound[of])
    rows = {row.look.label: row for row in found.readout(0).rows}
    velocity = summary["coefficients"][1]
    numbers = rows["ML, distances"].numbers
    assert np.allclose(numbers[1], 1e3 * velocity["value"])
    ratio = velocity["value"] / bound["coefficients"][1]
    spread = velocity["standard_error"] / bound["coefficients"][1]
    assert np.allclose(numbers[3:], (ratio, spread))
    assert rows["CRB, distances"].numbers[3:] == (1.0, 0.0)


def test_the_sweep_is_a_study_at_each_number_of_stamps() -> None:
    heard: list[tuple[int, int]] = []

    def progress(done: int, of: int) -> bool:
        heard.append((done, of))
        return True

    sweep = over_stamps(PAPER, TRIALS, progress)
    assert heard[-1] == (len(COUNTS) * TRIALS, len(COUNTS) * TRIALS) == (sweep.trials, sweep.asked)
    velocity = plot(sweep.plots(PAPER.to_dict()), "Velocity RMSE, Y1, m/s")
    assert velocity.x.tolist() == list(COUNTS)
    assert (velocity.logarithmic, velocity.logarithmic_x) == (True, True)
    assert [(each.x, each.look.label) for each in velocity.uprights] == [(100.0, "K = 100")]
    for index in (0, 3):
        scenario = swept(PAPER, COUNTS[index])
        assert scenario.to_dict()["stamps"]["count"] == COUNTS[index]
        report = Report(scenario.study(TRIALS))
        wanted = report.summaries["maximum-likelihood"]["coefficients"][1]
        each = line(velocity, "ML, distances")
        assert np.allclose((each.values[index], each.spread[index]), (wanted["value"], 2 * wanted["standard_error"]))
        bound = line(velocity, "CRB, distances").values[index]
        assert np.isclose(bound, scenario.bound(False).coefficient_rmse(1))
    rows = picture(PAPER, sweep).readout(0)
    assert "K = 100" in rows.groups[0][0]


def test_a_sweep_that_is_stopped_shows_what_it_has() -> None:
    sweep = over_stamps(PAPER, TRIALS, lambda done, _: done < 2 * TRIALS + 1)
    assert 2 <= len(sweep.studies) < len(COUNTS)
    assert sweep.trials < sweep.asked
    assert len(plot(sweep.plots(PAPER.to_dict()), "Position").x) == len(sweep.studies)


def test_what_does_not_change_a_study_leaves_it_standing() -> None:
    sweep, means = over_stamps(PAPER, 2, going), averages(PAPER, 2, going)
    gauged = PAPER.replace(view={"gauge": {"degrees": 30, "shift": [0, 0], "pivot": [0, 0]}})
    fewer, noisier = PAPER.replace({"stamps.count": 20}), PAPER.replace({"noise.sigma_distance": 0.5})
    assert [sweep.holds_for(each) for each in (gauged, fewer, noisier)] == [True, True, False]
    assert [means.holds_for(each) for each in (gauged, fewer, noisier)] == [True, False, False]


def test_findings_are_of_the_figures() -> None:
    told = picture(PAPER).sentences()[0]
    ratios = [f"{PAPER.bound(False).coefficient_rmse(n) / PAPER.bound(True).coefficient_rmse(n):.3g}" for n in range(3)]
    report = Report(PAPER.study(TRIALS))
    said = judged(report, "100 stamps")
    assert "20 trials" in said
    best = min(report.levels, key=lambda level: level.over_bound(1) or np.inf)
    assert f"{best.label} is at its bound in velocity ({reading(best.over_bound(1) or 0)} ± " in said
    bounds = {kind: report.coefficients(kind) for kind in report.bounds}
    only = PAPER.replace({"estimators.enabled": ["maximum-likelihood-accelerometers"]}).run()
    assert f"accelerometers buy {ratios[0]} × in position, {ratios[1]} × in velocity" in described(only, bounds)
    assert told
    assert described(PAPER.replace({"estimators.enabled": []}).run(), {}) == "No estimator is switched on."
    failing = picture(KinematicsScenario.preset("kinematics-four")).sentences()[0]
    assert "gives nothing" in failing


def test_sentences_of_the_panel_are_those_of_the_page() -> None:
    page = " ".join(
        re.sub(r"\s+", " ", each.read_text())
        for each in sorted((ROOT / "web/page/src/labs/anchorless/controls").iterdir())
    )
    for text in (gauge_panel.NONE, gauge_panel.ROUNDING, anchorless_panel.SENSING, anchorless_panel.NOT_SENSING):
        assert text in page
    assert on_degree(PAPER.to_dict()) in page
    assert "The motion has degree 2: " in on_degree(PAPER.replace({"estimators.degree": 1}).to_dict())


def test_accelerometers_go_and_come_back() -> None:
    enabled = PAPER.to_dict()["estimators"]["enabled"]
    without = with_accelerometers(enabled, False, enabled)
    assert (len(without), with_accelerometers(without, True, enabled)) == (3, enabled)
    assert with_accelerometers([], True)


def test_listed_stamps_are_spread_evenly_and_arrows_reach_as_the_link_says() -> None:
    listed = PAPER.replace(stamps={"kind": "listed", "times": [-2.0, 0.0, 1.0, 3.0]})
    even = spread_evenly(listed).to_dict()["stamps"]
    assert even == {"kind": "regular", "first": -2.0, "last": 3.0, "count": 4}
    seconds = [arrow_seconds(PAPER.replace(view=view).to_dict()) for view in (None, {"arrow_seconds": 4})]
    assert seconds == [20.0, 4.0]
    assert arrow_seconds(PAPER.replace(view={"arrow_seconds": -1}).to_dict()) == 20.0


def test_both_studies_run_in_the_background() -> None:
    with shown(PAPER) as (viewer, client):
        client.set(client.control("trials"), TRIALS)
        client.press("Over K, or stop")
        until(lambda: isinstance(viewer.shown.wish.study, Sweep))
        until(lambda: "Velocity RMSE, Y1, m/s" in str(client.of_type("GuiUplotMessage")))
        client.set(client.control("stamps K"), 50)
        until(lambda: viewer.shown.wish.source.to_dict()["stamps"]["count"] == 50)
        assert isinstance(viewer.shown.wish.study, Sweep)
        client.press("Average over trials, or stop")
        until(lambda: "RMSE, one alignment, m" in str(client.of_type("GuiUplotMessage")))
        client.set(client.control("mirror all nodes in x"), True)
        until(lambda: viewer.shown.wish.source.to_dict()["view"])
        assert viewer.shown.wish.study is not None
        client.press("Show the single run")
        until(lambda: viewer.shown.wish.study is None)
