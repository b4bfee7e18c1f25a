"""Both renderers draw shades, bonds, and a box that a barostat changes: pixels are read."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from drawn_box import BLUE, BOTH, LIGHT_BOX, RED, area, boxes
from frame_server import FrameServer, running
from playwright.sync_api import Browser

from gasbox.app.look import Look

pytestmark = pytest.mark.browser
LONELY, PAIRED, GAS = (0xDC, 0xC3, 0x1C), (0x9C, 0xCB, 0x35), (0xE6, 0x95, 0x00)
LIGHT_OUTSIDE = (242, 244, 247)


@pytest.fixture(scope="module")
def server() -> Iterator[FrameServer]:
    with running() as one:
        yield one


@pytest.fixture
def open_box(browser: Browser, server: FrameServer) -> Iterator[Any]:
    with boxes(browser, server) as opened:
        yield opened


@BOTH
def test_colours_say_what_is_asked_for(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(0, 10.0, 20.0), (2, 30.0, 20.0), (2, 33.5, 20.0)])
    places = (10, 30, 33.5)
    assert [box.color_at(x, 20) for x in places] == [RED, BLUE, BLUE]
    box.session.dress(Look("neighbours"))
    box.redrawn()
    assert [box.color_at(x, 20) for x in places] == [LONELY, PAIRED, PAIRED]
    box.session.dress(Look("phase"))
    box.redrawn()
    assert [box.color_at(x, 20) for x in places] == [GAS, GAS, GAS]
    box.session.show.simulation.state.velocity[0] = (1e-3, 0.0)
    box.session.dress(Look("speed"))
    box.redrawn()
    fast, slow, other = (box.color_at(x, 20) for x in places)
    assert slow == other != fast
    box.session.dress(Look())
    box.redrawn()
    assert [box.color_at(x, 20) for x in places] == [RED, BLUE, BLUE]


@BOTH
def test_highlighted_discs_stand_out_in_shades_too(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(0, 10.0, 20.0), (2, 30.0, 20.0)])
    box.session.dress(Look("phase"))
    box.session.highlight(2, 0.0, 1.0)
    box.redrawn()
    assert box.color_at(30, 20) == GAS
    assert box.color_at(10, 20)[2] > 180


@BOTH
def test_bonds_join_neighbours_between_smaller_discs(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(2, 30.0, 20.0), (2, 34.0, 20.0), (2, 40.0, 20.0)])
    assert box.color_at(32, 20) == LIGHT_BOX
    whole = area(box.screenshot(), BLUE, LIGHT_BOX)
    box.session.dress(Look(bonds=True))
    box.redrawn()
    assert sum(box.color_at(32, 20)) < 500
    assert box.color_at(37, 20) == LIGHT_BOX  # too far away
    assert box.color_at(30, 20) == BLUE
    assert area(box.screenshot(), BLUE, LIGHT_BOX) == pytest.approx(0.36 * whole, rel=0.05)


@BOTH
def test_bonds_go_through_periodic_sides(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(2, 1.8, 20.0), (2, 57.9, 20.0)])
    box.session.dress(Look(bonds=True))
    box.redrawn()
    for x in (0.4, 59.5):
        assert sum(box.color_at(x, 20)) < 500
    assert box.color_at(30, 20) == LIGHT_BOX


@BOTH
def test_a_box_that_shrinks_is_drawn_as_it_is_now(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(2, 0.3, 10.0), (0, 20.0, 10.0)])
    box.session.show.simulation.state.wall_displacement = np.array([0.0, -10.0, 0.0, -5.0])
    for _ in range(3):
        box.redrawn()
    assert box.color_at(0.8, 10) == BLUE
    assert box.color_at(49.8, 10) == BLUE  # the image at the side where it is now
    assert box.color_at(20, 10) == RED
    assert box.color_at(45, 30) == LIGHT_BOX
    assert box.color_at(53, 20) == LIGHT_OUTSIDE
    assert box.color_at(25, 38) == LIGHT_OUTSIDE


def test_the_view_follows_a_box_that_grows_or_shrinks_far(open_box: Any) -> None:
    box = open_box("cpu", [(0, 20.0, 10.0)])
    before = box.scale()
    state = box.session.show.simulation.state
    state.wall_displacement = np.array([0.0, 60.0, 0.0, 40.0])
    box.redrawn()
    assert box.scale() == pytest.approx(before / 2, rel=0.05)
    state.wall_displacement = np.array([0.0, -30.0, 0.0, -20.0])
    for _ in range(40):
        box.redrawn()
    assert box.scale() > 0.6 * before
    image = box.screenshot()
    inside = np.nonzero((image == LIGHT_BOX).all(axis=2))
    rows, columns = inside
    assert columns.mean() == pytest.approx(310, abs=4)  # it stays in the middle
    assert rows.mean() == pytest.approx(210, abs=4)
