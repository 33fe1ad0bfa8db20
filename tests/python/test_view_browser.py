"""The viewer in a real Chromium: a gizmo is dragged by the mouse, and the estimates move."""

import os
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page, sync_playwright
from rangelab import Scenario
from rangelab.view import Viewer
from rangelab.view.gizmos import ARROWS
from rangelab.view.shapes import rotation

WIDTH, HEIGHT = 1000, 700
ARGUMENTS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]


@pytest.fixture
def viewer() -> Iterator[Viewer]:
    found = Viewer(Scenario.preset("room"), port=0)
    yield found
    found.stop()


@pytest.fixture
def page(viewer: Viewer) -> Iterator[Page]:
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=ARGUMENTS)
        page = browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
        page.goto(viewer.address)
        page.get_by_text("Position error, m").wait_for(timeout=120_000)
        # The scene fades in.
        page.wait_for_timeout(6000)
        yield page
        browser.close()


def pixel(viewer: Viewer, point: NDArray[np.float64]) -> tuple[float, float]:
    """Where a point of the world is on the screen; the camera looks along +z, its y points down."""
    (client,) = viewer.server.get_clients().values()
    camera = client.camera
    x, y, z = rotation(np.asarray(camera.wxyz), 3).T @ (point - np.asarray(camera.position))
    focal = camera.image_height / 2 / np.tan(camera.fov / 2)
    return float(camera.image_width / 2 + focal * x / z), float(camera.image_height / 2 + focal * y / z)


def test_an_anchor_is_dragged_and_the_estimates_move(viewer: Viewer, page: Page, tmp_path: Path) -> None:
    pictures = Path(os.environ.get("PICTURES", tmp_path))
    page.screenshot(path=pictures / "viewer.png", timeout=120_000)
    before = viewer.shown
    anchor = before.run.anchors[0]
    arrow = ARROWS * float(np.ptp(before.outline, axis=0).max()) * np.array([0.7, 0.0, 0.0])
    from_x, from_y = pixel(viewer, anchor + arrow)
    to_x, to_y = pixel(viewer, anchor + 2.5 * arrow + np.array([1.0, 0.0, 0.0]))
    page.mouse.move(from_x, from_y)
    page.wait_for_timeout(500)
    page.mouse.down()
    for part in np.linspace(0.1, 1.0, 8):
        page.mouse.move(from_x + part * (to_x - from_x), from_y + part * (to_y - from_y))
        page.wait_for_timeout(100)
    page.mouse.up()
    end = time.monotonic() + 30
    while np.array_equal(viewer.shown.run.anchors[0], anchor) and time.monotonic() < end:
        page.wait_for_timeout(100)
    page.wait_for_timeout(3000)
    page.screenshot(path=pictures / "viewer-dragged.png", timeout=120_000)
    after = viewer.shown
    moved = after.run.anchors[0] - anchor
    assert moved[0] > 0.5, "the anchor moved along its red arrow"
    assert np.allclose(moved[1:], 0.0, atol=1e-6)
    assert np.array_equal(after.run.anchors[1:], before.run.anchors[1:])
    assert not np.array_equal(after.run["uc-kf"].positions, before.run["uc-kf"].positions)
    source = after.wish.source
    assert isinstance(source, Scenario)
    assert source.run().to_json() == after.run.to_json()
