"""The controls of pong, with NiceGUI's simulated user and a gas that needs no engine."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from free_flight import FreeFlight
from simulated_lab import Lab, asked, keeps_what_is_chosen
from surroundings import sample, walled
from test_page_studies import loaded

from gasbox.app.worlds.live_values import LiveValues
from gasbox.app.worlds.pong_tables import Laid
from gasbox.scenario import Scenario, parse
from gasbox.scenario.pong_table import BATS, VARIANTS, pong_table
from gasbox.state import SetGravity, SetWorld


class Player:
    """A world that only shows what it is given."""

    def __init__(self, shown: dict[str, Any]) -> None:
        self.shown = shown

    def view(self) -> dict[str, Any]:
        return self.shown

    def series(self) -> dict[str, Any]:
        return {}


def table(**choices: Any) -> Scenario:
    return parse(pong_table(**choices))


async def opened(lab: Lab, **choices: Any) -> None:
    scenario = table(**choices)
    await loaded(lab, scenario)
    await lab.until(lambda: lab.page.world.panel is not None)


async def test_a_game_hides_the_charts_and_shows_its_controls(lab: Lab) -> None:
    await opened(lab, points=7)
    assert not lab.page._show_charts
    assert (lab.one("pong-left").value, lab.one("pong-right").value) == ("human", "medium")
    assert lab.one("pong-points").value == 7
    assert not lab.page.surroundings.visible


async def test_bats_and_goal_lines_cannot_be_taken_away(lab: Lab) -> None:
    await opened(lab)
    names = lab.session.scenario.geometry().wall_names
    shown = {names[wall.index] for wall in lab.page.surroundings.walls}
    assert shown <= {"left", "right"}
    await lab.press("d")
    await lab.press("g")
    changes = lab.session.show.simulation.changes
    await lab.until(lambda: changes)
    assert [type(change) for _, change in changes] == [SetGravity]


async def test_what_is_chosen_is_set(lab: Lab) -> None:
    await opened(lab)
    lab.one("pong-right").set_value("hard")
    lab.one("pong-points").set_value(11)
    lab.one("pong-ball_speed").set_value(60.0)
    lab.one("pong-paddle_speed").set_value(70.0)
    lab.click("pong-again")
    wanted = [
        SetWorld("right", "hard"),
        SetWorld("points", 11),
        SetWorld("ball_speed", 60.0),
        SetWorld("paddle_speed", 70.0),
        SetWorld("restart", True),
    ]
    await lab.until(lambda: asked(lab) == wanted)


@pytest.mark.parametrize(
    ("marker", "value"), [("pong-right", "hard"), ("pong-points", 11), ("pong-ball_speed", 60.0)]
)
async def test_what_is_chosen_stays(lab: Lab, marker: str, value: Any) -> None:
    await opened(lab)
    await keeps_what_is_chosen(lab, marker, value)
    assert len(asked(lab)) == 1


async def test_serve_only_before_a_serve(lab: Lab) -> None:
    await opened(lab)
    simulation: Any = lab.session.show.simulation
    for phase, may in (("serve", True), ("play", False), ("over", False)):
        simulation.world = Player({"phase": phase})
        await lab.until(lambda may=may: lab.one("pong-serve").enabled is may)


@pytest.mark.parametrize("variant", VARIANTS)
async def test_another_table_keeps_players_and_points(lab: Lab, variant: str) -> None:
    await opened(lab, players=("easy", "human"), points=9, bat="small", gas=60)
    await lab.until(lambda: lab.one("pong-points").value == 9)
    assert (lab.one("pong-variant").value, lab.one("pong-gas").value) == ("gas", 60)
    assert lab.one("pong-bat").value == "small"
    lab.one("pong-variant").set_value(variant)
    if variant == "attractive":
        assert lab.one("pong-temperature").value == Laid.of(table(variant=variant)).temperature
    lab.one("pong-gas").set_value(40)
    lab.one("pong-bat").set_value("large")
    lab.click("pong-lay")
    wanted = table(variant=variant, gas=40, bat="large", players=("easy", "human"), points=9)
    await lab.until(lambda: lab.session.scenario == wanted)
    await lab.until(lambda: lab.page.world.panel is not None and lab.one("pong-bat").value == "large")


async def test_a_table_that_cannot_be_laid_is_explained(lab: Lab) -> None:
    await opened(lab)
    before = lab.session.scenario
    lab.one("pong-gas").set_value(1_000_000)
    lab.click("pong-lay")
    await lab.until(lambda: lab.one("pong-problem").text)
    assert lab.session.scenario is before


def test_each_bat_is_recognised_by_its_size() -> None:
    assert [Laid.of(table(bat=bat)).bat for bat in BATS] == list(BATS)
    assert [Laid.of(table(variant=variant)).variant for variant in VARIANTS] == list(VARIANTS)


def test_values_follow_what_was_set() -> None:
    first = sample(FreeFlight(walled()))
    values = LiveValues({"points": 3})
    assert values.of("points", first) == 3
    later = replace(first, changes=((0.0, SetWorld("points", 5)), (1.0, SetWorld("points", 8))))
    assert values.of("points", later) == 8
    assert values.of("nothing", later) is None
    assert values.of("points", replace(first, version=2)) == 3
