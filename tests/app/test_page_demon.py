"""The panel of a demon, with NiceGUI's simulated user and a gas that needs no engine."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from simulated_lab import Lab, asked, keeps_what_is_chosen
from test_page_studies import loaded

from gasbox.app.wall_controls import walls_with_controls
from gasbox.app.worlds.demon import meaning
from gasbox.app.worlds.demon_books import PICTURES, written
from gasbox.geometry import Enclosure
from gasbox.scenario import Scenario, load
from gasbox.state import SetWorld
from gasbox.worlds import MaxwellsDemon


async def opened(lab: Lab, name: str = "demon-sorting") -> MaxwellsDemon:
    """A demon beside a gas in free flight; what is set goes to it at once."""
    scenario: Scenario = load(name)
    await loaded(lab, scenario)
    await lab.until(lambda: lab.page.world.panel is not None)
    simulation: Any = lab.session.show.simulation
    demon = MaxwellsDemon(scenario)
    demon.start(simulation.state, scenario.geometry())
    apply = simulation.apply

    def applied(change: SetWorld) -> None:
        demon.take(change)
        apply(change)

    simulation.apply, simulation.world = applied, demon
    await lab.until(lambda: lab.one("demon-rule").value == demon.view()["rule"])
    return demon


async def test_what_is_chosen_is_set(lab: Lab) -> None:
    demon = await opened(lab)
    assert lab.one("demon-species").value == "orange"
    assert lab.page._show_charts
    lab.one("demon-species").set_value("blue")
    lab.click("demon-reversed")
    await lab.until(lambda: len(asked(lab)) == 2)
    lab.one("demon-rule").set_value("speed")
    panel: Any = lab.page.world.panel
    await lab.until(lambda: panel._speed.visible)
    lab.one("demon-threshold").set_value(1.5)
    wanted = [
        SetWorld("species", "blue"),
        SetWorld("reversed", True),
        SetWorld("rule", "speed"),
        SetWorld("threshold", 1.5),
    ]
    await lab.until(lambda: asked(lab) == wanted)
    await lab.until(lambda: lab.one("demon-says").text == "fast to the left, slow to the right")
    assert demon.view()["threshold"] == 1.5


@pytest.mark.parametrize(
    ("name", "marker", "value"),
    [
        ("demon-sorting", "demon-rule", "speed"),
        ("demon-sorting", "demon-species", "blue"),
        ("maxwells-demon", "demon-threshold", 1.5),
    ],
)
async def test_what_is_chosen_stays(lab: Lab, name: str, marker: str, value: Any) -> None:
    await opened(lab, name)
    await keeps_what_is_chosen(lab, marker, value)
    assert len(asked(lab)) == 1


async def test_what_others_set_is_shown_at_once(lab: Lab) -> None:
    """A hand on one control does not hold the others."""
    await opened(lab)
    demon: Any = lab.session.show.simulation.world
    panel: Any = lab.page.world.panel
    lab.one("demon-rule").set_value("speed")
    demon.take(SetWorld("species", "blue"))
    before: Any = lab.session.sample()
    panel.show(replace(before, world={**before.world, "species": "blue"}))
    assert (lab.one("demon-species").value, lab.one("demon-rule").value) == ("blue", "speed")


async def test_turned_twice_is_as_before(lab: Lab) -> None:
    demon = await opened(lab)
    for _ in range(2):
        lab.click("demon-reversed")
    await lab.until(lambda: len(asked(lab)) == 2)
    assert not demon.view()["reversed"]


async def test_only_what_belongs_to_the_rule_is_seen(lab: Lab) -> None:
    await opened(lab)
    panel: Any = lab.page.world.panel
    for rule, seen in (
        ("speed", (True, False, True)),
        ("species", (False, True, True)),
        ("direction", (False, False, True)),
        ("none", (False, False, False)),
    ):
        lab.one("demon-rule").set_value(rule)
        controls = panel._speed, panel._species, panel._swap
        await lab.until(lambda seen=seen, all=controls: tuple(one.visible for one in all) == seen)


@pytest.mark.parametrize(
    ("rule", "text"),
    [
        ("speed", "fast to the right, slow to the left"),
        ("species", "orange to the right, others to the left"),
        ("direction", "only to the right"),
        ("none", "everybody passes: nothing is decided"),
        ("closed", "nobody passes: nothing is decided"),
    ],
)
def test_what_a_rule_means(rule: str, text: str) -> None:
    view = {"rule": rule, "sides": ["left", "right"], "species": "orange", "reversed": False}
    assert meaning(view) == text
    turned = text.replace("left", "?").replace("right", "left").replace("?", "right")
    assert meaning({**view, "reversed": True}) == turned


def test_the_books_and_the_pictures() -> None:
    books = {"decisions": 1200, "information": 600 * math.log(2), "information_written": 1200 * math.log(2)}
    assert written(books) == {"bits": "1\u2009200 (600)", "heat": "–", "work": "–", "share": "–"}
    now = {"heat_of_forgetting": 832.0, "work_stored": -0.1, "entropy_of_gas": -240 * math.log(2)}
    assert written({**books, **now})["share"] == "20%"
    assert written({**books, **now})["work"] == "0"
    view = {**books, **now, "sides": ["left", "right"], "left": {"temperature": 0.5, "discs": 40}}
    names = (
        "count_left",
        "count_right",
        "temperature_left",
        "temperature_right",
        "entropy",
        "information",
        "written",
    )
    time = np.arange(2000.0)
    series = {"time": time, "balance": time, **dict.fromkeys(names, time)}
    for _, make in PICTURES.values():
        assert make(view, {}) is None
        picture = make(view, series)
        assert picture is not None
        for trace in picture.traces:
            assert len(trace.points) <= 300
            assert trace.points[-1].tolist() == [1999.0, 1999.0]


def test_nobody_takes_the_divider_of_a_demon_away() -> None:
    scenario = load("maxwells-demon")
    geometry = scenario.geometry()
    assert isinstance(geometry, Enclosure)
    assert walls_with_controls(scenario, geometry) == []
