"""The row for gravity and walls, with NiceGUI's simulated user and a gas that needs no engine."""

from __future__ import annotations

import pytest
from nicegui.events import GenericEventArguments
from simulated_lab import Lab
from surroundings import BOX, DIVIDER, matter, walled
from test_page_studies import loaded

from gasbox.geometry import Enclosure
from gasbox.state import MoveWall, SetGravity, SetWall

EVERYTHING = walled(
    walls={"left": {"temperature": 1.0, "name": "stove"}},
    obstacles=[DIVIDER],
)


def changes(lab: Lab) -> list[object]:
    return [change for _, change in lab.session.show.simulation.changes]


async def opened(lab: Lab) -> None:
    await loaded(lab, EVERYTHING)
    await lab.until(lambda: len(lab.page.surroundings.walls) == 2)


async def test_a_plain_gas_hides_the_row_and_a_key_shows_it(lab: Lab) -> None:
    assert not lab.page.surroundings.visible
    await opened(lab)
    assert lab.page.surroundings.visible


async def test_gravity_by_key_slider_pad_and_number(lab: Lab) -> None:
    await opened(lab)
    await lab.press("g")
    await lab.until(lambda: len(changes(lab)) == 1)
    (down,) = changes(lab)
    assert isinstance(down, SetGravity)
    assert down.gravity[0] == 0.0
    assert down.gravity[1] < 0.0
    await lab.press("g")
    await lab.until(lambda: changes(lab)[-1] == SetGravity((0.0, 0.0)))
    await lab.press("g")
    await lab.until(lambda: changes(lab)[-1] == down)
    lab.one("gravity-strength").set_value(1.0)
    await lab.until(lambda: len(changes(lab)) == 4)
    strong = changes(lab)[-1]
    assert isinstance(strong, SetGravity)
    assert strong.gravity[1] == pytest.approx(8 * down.gravity[1], rel=0.01)  # the cube of twice as much
    control = lab.page.surroundings.gravity
    with lab.user:
        control._tilted(
            GenericEventArguments(sender=control._pad, client=control._pad.client, args={"x": 0.5, "y": 0.0})
        )
    await lab.until(lambda: len(changes(lab)) == 5)
    right = changes(lab)[-1]
    assert isinstance(right, SetGravity)
    assert right.gravity == (pytest.approx(-down.gravity[1]), 0.0)
    lab.one("gravity-angle").set_value(90.0)
    lab.one("gravity-size").set_value(0.25)
    await lab.until(lambda: changes(lab)[-1] == SetGravity((0.0, 0.25)))
    await lab.until(lambda: lab.one("gravity-reading").text == "g = 0.250")
    lab.click("gravity-zero")
    await lab.until(lambda: changes(lab)[-1] == SetGravity((0.0, 0.0)))


async def test_no_gravity_without_a_floor(lab: Lab) -> None:
    await lab.press("g")  # periodic both ways
    assert changes(lab) == []
    await lab.until(lambda: lab.page.surroundings.visible)
    assert not lab.one("gravity-strength").enabled
    assert lab.one("gravity-reading").text == "no floor: periodic"
    await loaded(lab, walled(container={"shape": "rectangle", "width": 60, "height": 40, "periodic": ["y"]}))
    await lab.until(lambda: not lab.page.surroundings.visible)  # the page has seen the new gas
    await lab.press("g")
    await lab.until(lambda: changes(lab))
    (sideways,) = changes(lab)
    assert isinstance(sideways, SetGravity)
    assert sideways.gravity[0] > 0.0
    assert sideways.gravity[1] == 0.0


async def test_a_divider_goes_and_comes_back(lab: Lab) -> None:
    await opened(lab)
    await lab.press("d")
    await lab.until(lambda: changes(lab) == [SetWall("divider", present=False)])
    await lab.until(lambda: lab.one("wall-4-present").props["aria-label"] == "Put back divider")
    lab.click("wall-4-present")
    await lab.until(lambda: changes(lab)[-1] == SetWall("divider", present=True))
    geometry = lab.session.show.simulation.geometry
    assert isinstance(geometry, Enclosure)
    assert geometry.walls[4].present


async def test_the_temperature_of_a_wall(lab: Lab) -> None:
    await opened(lab)
    lab.one("wall-0-warmth").set_value(1.0)
    await lab.until(lambda: changes(lab) == [SetWall("stove", temperature=2.0)])
    lab.one("wall-0-temperature").set_value(0.5)
    await lab.until(lambda: changes(lab)[-1] == SetWall("stove", temperature=0.5))
    await lab.until(lambda: lab.one("wall-0-value").text == "T = 0.500")


async def test_a_divider_is_moved_by_a_number(lab: Lab) -> None:
    await opened(lab)
    lab.one("wall-4-goal").set_value(3.0)
    await lab.until(lambda: changes(lab))
    (moved,) = changes(lab)
    assert isinstance(moved, MoveWall)
    assert (moved.wall, moved.displacement) == ("divider", 3.0)
    await lab.until(lambda: lab.one("wall-4-value").text == "at 3.00")


async def test_under_forces_walls_move_and_go(lab: Lab) -> None:
    await loaded(lab, matter(container=BOX, walls=EVERYTHING.walls, obstacles=[DIVIDER]))
    await lab.until(lambda: [wall.index for wall in lab.page.surroundings.walls] == [0, 4])
    lab.click("wall-4-present")
    await lab.until(lambda: changes(lab) == [SetWall("divider", present=False)])


async def test_molecules_under_forces_know_walls_that_get_warmer_or_colder(lab: Lab) -> None:
    water = {"name": "water", "model": "water", "count": 3, "temperature": 1}
    await loaded(lab, matter(container=BOX, walls=EVERYTHING.walls, obstacles=[DIVIDER], molecules=[water]))
    await lab.until(lambda: [wall.index for wall in lab.page.surroundings.walls] == [0])
    assert lab.one("wall-0-value").text == "T = 1.00"
    lab.one("wall-0-temperature").set_value(0.5)
    await lab.until(lambda: changes(lab) == [SetWall("stove", temperature=0.5)])


async def test_what_cannot_be_done_is_said(lab: Lab) -> None:
    await opened(lab)
    with lab.user:
        lab.page.surroundings.send(SetWall("nobody", present=False))
    await lab.user.should_see("there is no wall nobody")
