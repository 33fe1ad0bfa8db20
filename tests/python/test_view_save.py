"""What goes out of the viewer and comes in: links of the page, and players of every lab."""

from pathlib import Path

import pytest
import rangelab
from rangelab import IndoorScenario, KinematicsScenario, Scenario
from rangelab.view import Viewer
from rangelab.view.labs import LABS
from rangelab.view.picture import Source
from rangelab.view.source import opened
from viewer_client import until
from viewer_labs import shown

ROOM = Scenario.preset("room").replace(steps=4)
OF_LABS: dict[str, Source] = {
    "track": ROOM,
    "explore": ROOM,
    "localize": ROOM,
    "indoor": IndoorScenario.preset("indoor-static"),
    "anchorless": KinematicsScenario.preset("kinematics-four").replace(steps=5),
    "replay": ROOM.simulate(),
}


@pytest.mark.parametrize(
    "scenario",
    [
        IndoorScenario.preset("indoor-u").replace({"ranging.sigma": 0.123, "beacons[0]": [0.1, 0.2, 0.3]}),
        KinematicsScenario.preset("kinematics-four").replace({"noise.sigma_distance": 0.123}),
    ],
)
def test_links_of_other_families_come_back_as_they_were(scenario: IndoorScenario | KinematicsScenario) -> None:
    link = rangelab.to_link(scenario, "https://example.org/")
    assert rangelab.from_link(link) == scenario
    assert opened(link) == scenario
    with shown(ROOM) as (viewer, client):
        client.set(client.control("link"), link)
        until(lambda: viewer.shown.wish.source == scenario)
        until(lambda: rangelab.to_link(scenario) in str(client.of_type("GuiUpdateMessage")))


def test_every_lab_has_a_document_here() -> None:
    assert set(OF_LABS) == set(LABS)


@pytest.mark.parametrize("lab", list(OF_LABS))
def test_every_lab_is_saved_as_a_player(tmp_path: Path, lab: str) -> None:
    viewer = Viewer(OF_LABS[lab], lab=lab, port=0)
    try:
        for ending in (".html", ".viser"):
            path = tmp_path / f"{lab}{ending}"
            viewer.save(path)
            assert path.stat().st_size > 10_000
        assert (tmp_path / f"{lab}.html").read_text().lstrip().lower().startswith("<!doctype html")
        with pytest.raises(ValueError, match="ends in"):
            viewer.save(tmp_path / "run.gif")
    finally:
        viewer.stop()
