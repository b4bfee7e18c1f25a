"""The page of an epidemic, with NiceGUI's simulated user and an epidemic that needs no engine."""

from __future__ import annotations

import functools
from collections.abc import AsyncIterator
from typing import Any

import pytest
from nicegui.testing import user_simulation
from people import FRAME, SETTINGS, People, epidemic
from simulated_lab import Lab

from gasbox.app.page import Page, build
from gasbox.app.registry import Registry
from gasbox.app.session import Session
from gasbox.app.worlds.epidemic import EpidemicPanel
from gasbox.scenario.epidemic import Epidemic
from gasbox.state import Change, SetWorld


@pytest.fixture
async def places() -> int:
    return 3


@pytest.fixture
async def town(monkeypatch: pytest.MonkeyPatch, places: int) -> AsyncIterator[Lab]:
    monkeypatch.setattr(Epidemic, "SETTINGS", SETTINGS)
    make: Any = functools.partial(Session, simulate=People, unwatched=True)  # type: ignore[arg-type]
    registry = Registry(places, make)
    pages: list[Page] = []
    async with user_simulation(root=lambda: pages.append(build(registry.open(epidemic())))) as user:
        await user.open("/")
        lab = Lab(user, pages[-1])
        lab.session.start()
        await lab.until(lambda: isinstance(panel(lab), EpidemicPanel) and panel(lab)._last is not None)
        yield lab
        registry.close()


def panel(lab: Lab) -> Any:
    return lab.page.world.panel


def seated(lab: Lab) -> int:
    assert isinstance(lab.session.home, Registry)
    return lab.session.home.seated


def time_of(session: Session) -> float:
    return session.show.simulation.time


def changes(session: Session) -> list[Change]:
    return [change for _, change in session.show.simulation.changes]


async def test_a_slider_and_a_number_act_at_once(town: Lab) -> None:
    town.one("dial-hygiene").set_value(0.5)
    await town.until(lambda: changes(town.session) == [SetWorld("hygiene", 0.5)])
    assert town.one("number-hygiene").value == 0.5
    town.one("number-infectious_days").set_value(8.0)
    await town.until(lambda: changes(town.session)[-1] == SetWorld("infectious_days", 8.0))


async def test_what_a_schedule_sets_is_seen(town: Lab) -> None:
    town.session.change(SetWorld("distancing", 1.0))
    await town.until(lambda: town.one("number-distancing").value == 1.0)
    assert len(changes(town.session)) == 1  # showing it asks for nothing


async def test_side_by_side(town: Lab) -> None:
    one = panel(town)
    town.one("dial-hygiene").set_value(0.5)
    await town.until(lambda: changes(town.session))
    town.click("side-by-side")
    await town.until(lambda: one.pair is not None)
    second = one.pair.second
    assert changes(town.session) == []
    assert changes(second) == [SetWorld("hygiene", 0.5)]
    assert not town.session.playing
    town.one("dial-hygiene").set_value(0.2)
    await town.until(lambda: changes(second)[-1] == SetWorld("hygiene", 0.2))
    assert changes(town.session) == []
    town.click("end-compare")
    await town.until(lambda: one.pair is None)
    await town.until(lambda: seated(town) == 1)


async def test_both_run_in_step_and_stop_together(town: Lab) -> None:
    one = panel(town)
    town.click("side-by-side")
    await town.until(lambda: one.pair is not None)
    first, second = town.session, one.pair.second
    times: list[tuple[float, float]] = []

    def late() -> bool:
        times.append((time_of(first), time_of(second)))
        return times[-1][0] > 2.0

    await town.press(" ")
    first.set_speed(5.0)
    await town.until(late)
    assert max(abs(a - b) for a, b in times) <= 3.0 * 5.0 * FRAME
    await town.press(" ")
    await town.until(lambda: not second.playing and time_of(first) == time_of(second))
    at = time_of(first)
    await town.press("ArrowRight")
    await town.until(lambda: at < time_of(first) == time_of(second))
    town.one("dial-hygiene").set_value(0.5)
    await town.until(lambda: changes(second))
    await town.press("r")
    await town.until(lambda: time_of(first) == time_of(second) == 0.0)
    await town.until(lambda: changes(second) == [SetWorld("hygiene", 0.5)])  # they last
    assert changes(first) == []


@pytest.mark.parametrize("places", [1])
async def test_no_place_for_a_second_box(town: Lab) -> None:
    town.click("side-by-side")
    await town.user.should_see("All 1 places of this lab are taken.")
    assert panel(town).pair is None
    assert seated(town) == 1


async def test_a_curve_is_kept_and_the_run_begins_again(town: Lab) -> None:
    one = panel(town)
    town.one("dial-hygiene").set_value(0.5)
    town.session.set_speed(20.0)
    await town.until(lambda: one._last.day > 2.0)
    town.click("keep")
    await town.until(lambda: one._kept is not None)
    assert not town.session.playing
    assert time_of(town.session) == 0.0
    assert changes(town.session) == [SetWorld("hygiene", 0.5)]
    town.session.play()
    await town.until(lambda: one._last.day > 1.0 and one._plots["runs"].told)
    rows = one._plots["runs"].told["dataset"]["source"]
    assert None not in rows[0]
    assert rows[0][1] == rows[0][2]  # the same start
    await town.until(lambda: one.numbers._values["peak"][1].text)
    town.click("end-compare")
    await town.until(lambda: one._kept is None and not one._plots["runs"].root.visible)


async def test_everybody_is_in_the_stacked_chart(town: Lab) -> None:
    one = panel(town)
    town.session.set_speed(50.0)
    await town.until(lambda: one._last.day > 20.0)
    plot = one._plots["stages"]
    stacked = plot.chart.options["series"]
    assert {series["stack"] for series in stacked} == {"people"}
    rows = plot.told["dataset"]["source"]
    assert {sum(row[1:]) for row in rows} == {200.0}
    assert len(rows[0]) == 1 + len(stacked)


async def test_another_scenario_ends_the_comparison(town: Lab) -> None:
    one = panel(town)
    town.click("side-by-side")
    await town.until(lambda: one.pair is not None)
    await town.upload("other.json", epidemic(100).to_json().encode())
    await town.until(lambda: seated(town) == 1)
    await town.until(lambda: panel(town) is not one and panel(town)._last is not None)
    assert town.session.show.partner is None
