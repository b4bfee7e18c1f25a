"""Both renderers draw the right discs, at the right places, in a real browser: pixels are read."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from drawn_box import BLUE, BOTH, DARK_BOX, GREEN, LIGHT_BOX, RED, area, boxes
from frame_server import FrameServer, running
from free_flight import gas
from playwright.sync_api import Browser

pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def server() -> Iterator[FrameServer]:
    with running() as one:
        yield one


@pytest.fixture
def open_box(browser: Browser, server: FrameServer) -> Iterator[Any]:
    with boxes(browser, server) as opened:
        yield opened


@BOTH
@pytest.mark.parametrize("ratio", [1.0, 2.0])
def test_a_disc_has_its_colour_its_place_and_its_size(open_box: Any, renderer: str, ratio: float) -> None:
    box = open_box(renderer, [(2, 30.0, 20.0)], ratio)
    image = box.screenshot()
    assert image.shape[:2] == (420 * ratio, 620 * ratio)
    assert box.color_at(30, 20) == BLUE
    assert box.color_at(10, 10) == LIGHT_BOX
    blue = (image == BLUE).all(axis=2)
    rows, columns = np.nonzero(blue)
    px, py = box.place(30, 20)
    assert columns.mean() + 0.5 == pytest.approx(px, abs=0.3)
    assert rows.mean() + 0.5 == pytest.approx(py, abs=0.3)
    radius = 1.5 * box.scale()
    assert area(image, BLUE, LIGHT_BOX) == pytest.approx(np.pi * radius**2, rel=0.02)
    assert np.ptp(columns) + 1 == pytest.approx(2 * radius, abs=1.5)


@BOTH
def test_small_discs_cover_their_true_area(open_box: Any, renderer: str) -> None:
    places = [(0, 1.0 + 2.013 * k, 5.0 + 1.171 * k) for k in range(25)]
    wide = {"container": {"shape": "rectangle", "width": 600, "height": 400}}
    box = open_box(renderer, places, **wide)
    radius = 0.5 * box.scale()
    assert 0.4 < radius < 0.6
    covered = area(box.screenshot(), RED, LIGHT_BOX)
    assert covered == pytest.approx(25 * np.pi * radius**2, rel=0.25 if renderer == "gl" else 0.05)


@BOTH
def test_every_species_has_its_own_colour(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(0, 10.0, 20.0), (1, 30.0, 20.0), (2, 50.0, 20.0)])
    assert [box.color_at(x, 20) for x in (10, 30, 50)] == [RED, GREEN, BLUE]


@BOTH
def test_y_points_up(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(2, 30.0, 35.0)])
    rows, _ = np.nonzero((box.screenshot() == BLUE).all(axis=2))
    assert rows.mean() < 420 / 2


@BOTH
def test_images_are_drawn_where_the_box_is_periodic(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(2, 0.3, 39.8)])
    image = box.screenshot()
    left, top = box.place(0, 40)
    right, bottom = box.place(60, 0)
    blue = (image == BLUE).all(axis=2)
    for row in (round(top) + 2, round(bottom) - 3):
        for column in (round(left) + 2, round(right) - 3):
            assert blue[row, column]
    radius = 1.5 * box.scale()
    assert area(image, BLUE, LIGHT_BOX) == pytest.approx(np.pi * radius**2, rel=0.05)  # cut at the sides
    assert not blue[:, : round(left) - 3].any()
    assert not blue[:, round(right) + 3 :].any()


@BOTH
def test_no_images_at_walls(open_box: Any, renderer: str) -> None:
    walled = {"container": {"shape": "rectangle", "width": 60, "height": 40}}
    box = open_box(renderer, [(2, 1.5, 20.0)], **walled)
    rows, columns = np.nonzero((box.screenshot() == BLUE).all(axis=2))
    assert columns.max() < 310
    assert rows.size > 0


@BOTH
def test_walls_are_solid_and_periodic_sides_dashed(open_box: Any, renderer: str) -> None:
    half = {"container": {"shape": "rectangle", "width": 60, "height": 40, "periodic": ["x"]}}
    image = open_box(renderer, [(0, 30.0, 20.0)], **half).screenshot()
    dark = image.sum(axis=2) < 450
    across, along = dark.sum(axis=1), dark.sum(axis=0)
    assert across.max() > 595  # bottom and top: walls
    assert 150 < along.max() < 300  # left and right: about every second pixel of 400


@BOTH
def test_highlighted_discs_stand_out(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(0, 10.0, 20.0), (2, 30.0, 20.0)])
    box.session.show.simulation.state.velocity[1] = (0.001, 0.0)
    box.session.highlight(2, 0.0005, 0.002)
    box.redrawn()
    assert box.color_at(30, 20) == BLUE
    dimmed = box.color_at(10, 20)
    assert dimmed[0] == 255
    assert min(dimmed[1:]) > 180
    box.session.clear_highlight()
    box.redrawn()
    assert box.color_at(10, 20) == RED


@BOTH
def test_a_followed_disc_has_a_ring_and_a_trail(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(0, 10.0, 20.0), (2, 30.0, 20.0)])
    box.session.show.simulation.state.velocity[0] = (4.0, 0.0)
    assert (box.screenshot().sum(axis=2)[100:300, 50:550] > 150).all()
    box.session.follow(0)
    for _ in range(5):
        box.redrawn()
    image = box.screenshot()
    ring = image[100:300, 50:550].sum(axis=2) < 150
    assert ring.sum() > 20
    x = box.session.followed().position[0]
    assert x == pytest.approx(20.0)
    assert sum(box.color_at(x - 4.0, 20)) < 600
    assert box.color_at(x, 20) == RED


@BOTH
def test_the_canvas_follows_its_element(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(2, 30.0, 20.0)])
    before = box.scale()
    box.page.evaluate("document.getElementById('box').style.width = '320px'")
    box.wait(f"lab.view.scale < {0.6 * before}")
    box.page.wait_for_timeout(100)
    image = box.screenshot()
    assert image.shape[1] == 320
    assert area(image, BLUE, LIGHT_BOX) == pytest.approx(np.pi * (1.5 * box.scale()) ** 2, rel=0.03)


@BOTH
def test_light_and_dark(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(2, 30.0, 20.0)])
    assert box.color_at(10, 10) == LIGHT_BOX
    box.page.emulate_media(color_scheme="dark")
    box.page.wait_for_timeout(200)
    assert box.color_at(10, 10) == DARK_BOX
    box.page.evaluate("document.documentElement.dataset.theme = 'light'")
    box.page.wait_for_timeout(200)
    assert box.color_at(10, 10) == LIGHT_BOX
    assert box.color_at(30, 20) == BLUE


def test_software_graphics_are_left_to_the_cpu(browser: Browser, server: FrameServer) -> None:
    session = server.registry.open(gas())
    page = browser.new_page()
    page.goto(server.page(session))
    page.wait_for_function("window.gasboxStats?.drawn > 0")
    name = page.evaluate(
        """() => {
          const gl = document.createElement("canvas").getContext("webgl2");
          const info = gl?.getExtension("WEBGL_debug_renderer_info");
          return info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : "";
        }"""
    )
    software = not name or any(word in name.lower() for word in ("swiftshader", "llvmpipe", "software"))
    assert page.evaluate("gasboxStats.renderer") == ("cpu" if software else "gl")
    page.close()
