"""Zooming, moving and picking in the box, with mouse, fingers and keyboard."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from drawn_box import BLUE, BOTH, LIGHT_BOX, area, boxes
from frame_server import FrameServer, running
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
def test_zoom_keeps_radii_true_and_resets(open_box: Any, renderer: str) -> None:
    box = open_box(renderer, [(2, 30.0, 20.0)])
    whole = box.scale()
    px, py = box.place(30, 20)
    box.page.mouse.move(px, py)
    box.page.mouse.wheel(0, -900)
    box.wait(f"lab.view.scale > {2 * whole}")
    box.page.wait_for_timeout(100)
    assert box.place(30, 20) == pytest.approx((px, py), abs=0.5)
    radius = 1.5 * box.scale()
    assert area(box.screenshot(), BLUE, LIGHT_BOX) == pytest.approx(np.pi * radius**2, rel=0.02)
    box.page.keyboard.press("0")
    box.wait(f"Math.abs(lab.view.scale - {whole}) < 1e-9")


def test_drag_moves_the_zoomed_box(open_box: Any) -> None:
    box = open_box("cpu", [(2, 30.0, 20.0)])
    px, py = box.place(30, 20)
    box.page.mouse.move(px, py)
    box.page.mouse.wheel(0, -900)
    box.page.mouse.down()
    box.page.mouse.move(px + 40, py + 25, steps=4)
    box.page.mouse.up()
    assert box.place(30, 20) == pytest.approx((px + 40, py + 25), abs=1)
    assert box.page.evaluate("picked") == []
    box.page.mouse.dblclick(px, py)
    assert box.page.evaluate("lab.view.zoom") == 1


def test_a_click_picks_a_disc_or_none(open_box: Any) -> None:
    box = open_box("cpu", [(0, 10.0, 20.0), (2, 30.0, 20.0)])
    for x, y in [(10.0, 20.2), (31.0, 20.5), (45.0, 10.0)]:
        box.page.mouse.click(*box.place(x, y))
    assert box.page.evaluate("picked") == [0, 1, None]


def test_two_fingers_zoom(open_box: Any) -> None:
    box = open_box("cpu", [(2, 30.0, 20.0)])
    whole, (px, py) = box.scale(), box.place(30, 20)
    touch = box.page.context.new_cdp_session(box.page)

    def send(kind: str, *fingers: float) -> None:
        points = [{"x": px + x, "y": py, "id": number} for number, x in enumerate(fingers)]
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    send("touchStart", -40.0, 40.0)
    for spread in (60.0, 80.0, 100.0):
        send("touchMove", -spread, spread)
    send("touchEnd")
    assert box.scale() == pytest.approx(2.5 * whole, rel=0.1)
    assert box.place(30, 20) == pytest.approx((px, py), abs=5)
    assert box.page.evaluate("picked") == []
