"""Sliders and curves of an epidemic, without any page."""

from __future__ import annotations

import numpy as np
import pytest

from gasbox.app.worlds.epidemic import options
from gasbox.app.worlds.epidemic.course import Course, chosen, marks
from gasbox.app.worlds.epidemic.dials import dials
from gasbox.app.worlds.thinning import thinned
from gasbox.scenario import ScheduledChange, load, shipped
from gasbox.scenario.epidemic import Epidemic
from gasbox.state import Change, SetGravity, SetWorld
from gasbox.theory.epidemic import final_size

SHIPPED = [name for name in shipped() if isinstance(load(name).world, Epidemic)]


@pytest.mark.parametrize("name", SHIPPED)
def test_every_setting_has_a_slider_that_can_show_its_value(name: str) -> None:
    world = load(name).world
    assert isinstance(world, Epidemic)
    values = world.values()
    groups = dials(world.SETTINGS, values, 1000)
    found = {dial.name: dial for _, mine in groups for dial in mine}
    assert found.keys() == values.keys()
    assert [group.title for group, _ in groups][-1] != "More"
    for setting, dial in found.items():
        value = values[setting]
        assert dial.low <= value <= dial.high
        assert dial.value(dial.place(value)) == pytest.approx(value, rel=0.06, abs=0.01 * dial.high)
        ends = [dial.value(0.0), dial.value(1.0)]
        assert ends[0] < ends[1] <= dial.setting.greatest
        assert ends[0] >= dial.setting.least
        assert dial.setting.meaning[1:] in dial.hint


def test_all_settings_are_known() -> None:
    values = dict.fromkeys(Epidemic.SETTINGS, 1.0)
    assert [group.title for group, _ in dials(Epidemic.SETTINGS, values, 1000)][-1] == "Vaccination"


def test_a_dragged_slider_leaves_one_mark() -> None:
    changes: list[tuple[float, Change]] = [
        (20.0, SetWorld("hygiene", 0.5)),
        (30.0, SetGravity((0.0, 0.0))),
        (40.0, SetWorld("travel_rate", 0.1)),
        (40.4, SetWorld("travel_rate", 0.2)),
        (41.0, SetWorld("travel_rate", 0.3)),
    ]
    assert [(one.day, one.name, one.value) for one in marks(changes, 2.0)] == [
        (10.0, "hygiene", 0.5),
        (20.5, "travel_rate", 0.3),
    ]
    schedule = [ScheduledChange(at=20.0, setting="hygiene", value=0.5)]
    assert chosen(changes, schedule) == {"travel_rate": 0.3}


def test_what_a_long_run_sends_is_bounded() -> None:
    for count in (0, 1, 5, 240, 241, 10_000):
        rows = thinned(count)
        assert rows.size <= 240
        assert not count or (rows[0], rows[-1]) == (0, count - 1)


def test_the_course_of_an_epidemic_and_what_theory_expects() -> None:
    days = np.array([0.0, 1.0, 2.0])
    series = {
        "day": days,
        "susceptible": np.array([90.0, 80.0, 60.0]),
        "exposed": np.array([0.0, 5.0, 10.0]),
        "infectious": np.array([10.0, 15.0, 20.0]),
        "recovered": np.array([0.0, 0.0, 10.0]),
        "r": np.array([np.nan, 2.0, 1.0]),
    }
    view = {
        "day": 2.0, "people": 100, "infected": 30, "total_infected": 40, "r": 1.0, "r0": 2.0, "over": False,
        "peak": {"infected": 30, "fraction": 0.3, "day": 2.0}, "counts": {},
    }  # fmt: skip
    course = Course.of(view, series)
    assert course.share.tolist() == [0.1, 0.2, 0.3]
    assert course.attack == pytest.approx(30 / 90)
    assert course.expected == pytest.approx(final_size(2.0, 0.9, 0.1) / 0.9)
    told = options.spread_now(course, None)
    assert told["dataset"]["source"] == [[0.0, None, None], [1.0, 2.0, None], [2.0, 1.0, None]]
    both = options.runs_now(course, course)["dataset"]["source"]
    assert both == [[0.0, 10.0, 10.0], [1.0, 20.0, 20.0], [2.0, 30.0, 30.0]]
    rows = options.stages_now(series, [])["dataset"]["source"]
    assert [sum(row[1:]) for row in rows] == [100.0, 100.0, 100.0]
