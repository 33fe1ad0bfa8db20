"""The studies of the viewer's Track lab: what they give, what they depend on, and that they end with what is shown."""

import threading
from typing import Any

import numpy as np
import pytest
from rangelab import Scenario
from rangelab.view.labs.track_budget import PAPER, THRESHOLDS, Budget, budget
from rangelab.view.labs.track_draws import Draws, anchor_draws
from rangelab.view.study_page import StudyPage
from viewer_client import until
from viewer_labs import shown

ROOM = Scenario.preset("room").replace(steps=10)
TITLES = ("Average over trials", "ET budget", "Anchor draws")
MANY = 100_000


def told(_done: int, _of: int) -> bool:
    return True


def studying() -> bool:
    return "rangelab-study" in {thread.name for thread in threading.enumerate()}


def test_the_budget_is_the_crates_over_all_thresholds() -> None:
    page = budget(ROOM, 20, told)
    assert (page.asked, page.trials) == (20, 20)
    rows = ROOM.budget_study(THRESHOLDS, 20).to_dict()["rows"]
    assert np.array_equal(page.thresholds, [row["epsilon"] for row in rows])
    spent = page.curve("projections")
    assert np.array_equal(spent.values, [row["projections"]["value"] for row in rows])
    assert page.spent_at(PAPER) == pytest.approx(spent.values[12], rel=1e-12)
    by_threshold = page.plots(ROOM.to_dict())[-1]
    spread = by_threshold.lines[0].spread
    assert spread is not None
    assert np.array_equal(spread, 2 * spent.standard_errors)


def test_draws_have_a_point_for_each_that_has_a_condition() -> None:
    page = anchor_draws(ROOM, 12, told)
    assert (page.asked, page.trials) == (12, 12)
    found = ROOM.anchor_draws(12)
    plot = page.plots(ROOM.to_dict())[0]
    assert np.array_equal(plot.x, np.sort(found.conditions[:, 1][np.isfinite(found.conditions[:, 1])]))


@pytest.mark.parametrize(
    ("page", "same", "other"),
    [
        (budget(ROOM, 2, told), {"estimators.threshold.epsilon": 0.3}, {"noise.sigma": 0.02}),
        (anchor_draws(ROOM, 2, told), {"estimators.enabled": ["kf"]}, {"steps": 9}),
    ],
)
def test_a_study_is_kept_by_edits_that_it_does_not_depend_on(page: StudyPage, same: Any, other: Any) -> None:
    assert page.holds_for(ROOM.replace(same))
    assert not page.holds_for(ROOM.replace(other))


@pytest.mark.parametrize(("title", "kind"), [("ET budget", Budget), ("Anchor draws", Draws)])
def test_a_study_is_asked_for_and_shown(title: str, kind: type) -> None:
    with shown(ROOM) as (viewer, client):
        client.set(client.control("trials"), 20)
        client.press(f"{title}, or stop")
        until(lambda: isinstance(viewer.shown.wish.study, kind))
        study = viewer.shown.wish.study
        assert isinstance(study, StudyPage)
        wanted = [plot.title for plot in study.plots(ROOM.to_dict())]
        until(lambda: set(wanted) <= {m["props"]["title"] for m in client.of_type("GuiUplotMessage")})
        client.press("Show the single run")
        until(lambda: viewer.shown.wish.study is None)


@pytest.mark.parametrize("title", TITLES)
def test_a_study_has_ended_when_the_viewer_has(title: str) -> None:
    with shown(ROOM.replace(steps=500)) as (_, client):
        client.set(client.control("trials"), MANY)
        client.press(f"{title}, or stop")
        until(studying)
    assert not studying()
