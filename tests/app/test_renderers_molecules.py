"""Both renderers draw molecules: pixels are read."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import pytest
from drawn_box import BLUE, BOTH, LIGHT_BOX, Box, boxes
from frame_server import FrameServer, running
from free_rotors import DUMBBELL, FreeRotors, rotors
from playwright.sync_api import Browser

from gasbox.app.look import Look

pytestmark = pytest.mark.browser
GREEN = (0, 160, 0)
GAS = (0xE6, 0x95, 0x00)
SPRING = {
    "atoms": [{"position": [-1.5, 0], "color": "#ff0000"}, {"position": [1.5, 0], "color": "#00a000"}],
    "bonds": [{"atoms": [0, 1], "stiffness": 10.0}],
    "count": 0,
}


@pytest.fixture(scope="module")
def server() -> Iterator[FrameServer]:
    with running(simulate=FreeRotors) as one:
        yield one


@pytest.fixture
def open_box(browser: Browser, server: FrameServer) -> Iterator[Any]:
    with boxes(browser, server) as opened:
        yield opened.shown  # type: ignore[attr-defined]


def pale(color: tuple[int, ...], seen: tuple[int, ...]) -> bool:
    """Whether it is this colour mixed with that of the box."""
    return seen == tuple(round(0.45 * c + 0.55 * b) for c, b in zip(color, LIGHT_BOX, strict=True))


def pointed(box: Box, x: float, y: float, name: str) -> list[str]:
    """What is told of the particle there, line by line, once it is told of this one."""
    box.page.mouse.move(*box.place(x, y))
    box.wait(f"document.querySelector('.gasbox-tip:not([hidden])')?.textContent.startsWith('{name}\\n')")
    return str(box.page.evaluate("document.querySelector('.gasbox-tip').textContent")).split("\n")[1:]


@BOTH
def test_molecules_are_turned_discs_with_sticks(open_box: Any, renderer: str) -> None:
    listed = [
        {"species": "molecule 0", "position": [20, 20], "angle": math.pi / 2, "angular_velocity": 2.0},
        {"species": "molecule 0", "position": [59.5, 10], "angle": 0.0},
        {"species": "molecule 1", "position": [40, 20], "angle": math.pi},
        {"species": "argon", "position": [40, 30]},
        {"species": "molecule 2", "position": [50, 33], "angle": math.pi / 2},
    ]
    argon = {"name": "argon", "radius": 1.0, "color": "#0000ff"}
    dumbbell = {**DUMBBELL, "count": 0}
    blue, green = (
        {"position": place, "color": color} for place, color in (([-2, 1], "#0000ff"), ([2, -1], "#00a000"))
    )
    oblique = {"atoms": [blue, green], "count": 0}
    forced = {"kind": "forced"}
    scenario = rotors(dumbbell, SPRING, oblique, species=(argon,), particles=listed, dynamics=forced)
    box = open_box(renderer, scenario, 5)
    # Upright: blue below, green above, each pale around a core; between them a stick.
    assert [box.color_at(20, y) for y in (17.6, 22.4)] == [BLUE, GREEN]
    assert pale(BLUE, box.color_at(21.2, 18))
    assert box.color_at(20, 20) not in (BLUE, GREEN, LIGHT_BOX)
    assert box.color_at(22, 20) == LIGHT_BOX
    # (x, y) comes to (-y, x) by a quarter turn.
    assert [box.color_at(x, y) for x, y in ((49, 30.8), (51, 35.2))] == [BLUE, GREEN]
    # The other atom of the second one is seen at the far side of the periodic box.
    assert box.color_at(57.1, 10) == BLUE
    assert box.color_at(1.9, 10) == GREEN
    # Pointed at, it tells what it has.
    _, turning, _, flight, rotation = pointed(box, 20, 18, "molecule 0 no. 0")
    assert (turning, flight) == ("angular velocity 2", "  of flight 0")
    assert float(rotation.split()[-1]) > 0.0
    # What bends is where its discs are, not where it was made.
    assert [box.color_at(x, 20) for x in (41.7, 38.3)] == [(255, 0, 0), GREEN]
    box.session.show.simulation.state.sites.place[5] += (0.0, -5.0)  # turned by half a turn
    box.session.dress(Look("phase"))
    box.redrawn()
    assert box.color_at(38.3, 25) == GAS
    assert box.color_at(40, 30) == GAS
    assert pointed(box, 40, 30, "argon no. 3") == ["speed 0", "energy 0"]
    box.page.mouse.move(*box.place(10, 35))
    box.wait("document.querySelector('.gasbox-tip').hidden")
    box.page.mouse.click(*box.place(59.5 - 2, 10))
    box.wait("picked.length > 0")
    assert box.page.evaluate("picked") == [1]
