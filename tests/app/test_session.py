"""A session: its thread, its orders, who looks, and what it hands out."""

from __future__ import annotations

import subprocess
import sys
import threading
import time
from typing import Any

import numpy as np
import pytest
from free_flight import FreeFlight, gas
from session_steps import frames, open_mailbox, until

from gasbox.app.mailbox import Mailbox
from gasbox.app.session import Session
from gasbox.errors import Problem, ScenarioError, UsageError


def test_it_costs_nothing_before_it_starts(session: Session) -> None:
    before = threading.active_count()
    assert session.sample() is None
    session.play()
    session.set_speed(2.0)
    session.clear_highlight()
    assert not session.started
    assert threading.active_count() == before


def test_time_runs_and_stands_still(session: Session) -> None:
    session.start()
    until(lambda: (sample := session.sample()) and sample.time > 1.0)
    session.pause()
    session.settle()
    stopped = session.sample()
    time.sleep(0.1)
    assert session.sample() is stopped
    assert stopped is not None
    assert not stopped.playing
    session.toggle()
    until(lambda: (sample := session.sample()) and sample.time > stopped.time)


def test_a_sample_is_a_copy(paused: Session) -> None:
    first = paused.sample()
    paused.step().result(5)
    second = paused.sample()
    assert first is not None
    assert second is not None
    assert first.time == 0.0
    assert second.time == 0.5
    assert not np.shares_memory(first.state.position, second.state.position)
    assert not np.array_equal(first.state.position, second.state.position)


def test_reset_gives_the_same_start(paused: Session) -> None:
    start = paused.sample()
    for _ in range(3):
        paused.step()
    paused.reset().result(5)
    again = paused.sample()
    assert start is not None
    assert again is not None
    assert again.time == 0.0
    assert again.version == start.version + 1
    np.testing.assert_array_equal(again.state.position, start.state.position)


def test_speed_has_limits(session: Session) -> None:
    session.set_speed(1000.0)
    assert session.speed == 100.0
    session.set_speed(0.0)
    assert session.speed == 0.1
    with pytest.raises(UsageError, match=r"0\.1"):
        session.set_speed(float("nan"))


def test_load_replaces_the_gas_when_it_returns(paused: Session) -> None:
    other = gas((7,))
    paused.load(other)
    sample = paused.sample()
    assert sample is not None
    assert paused.scenario is other
    assert (sample.scenario, sample.state.count, sample.version) == (other, 7, 2)


def test_a_refused_load_leaves_the_old_gas_alone() -> None:
    def refuse(scenario: Any) -> Any:
        if len(scenario.species) == 1:
            raise ScenarioError([Problem("species", "too much", "less")])
        return FreeFlight(scenario)

    session = Session(gas(), unwatched=True, simulate=refuse)
    session.pause()
    session.start()
    session.settle()
    before = session.sample()
    with pytest.raises(ScenarioError):
        session.load(gas((7,)))
    session.settle()
    assert session.sample() is before
    assert len(session.scenario.species) == 2
    session.close()


def test_a_gas_that_cannot_be_made_is_reported() -> None:
    def fail(_: Any) -> Any:
        raise ScenarioError([Problem("container", "nothing", "something")])

    session = Session(gas(), simulate=fail)
    mailbox = Mailbox(ring=lambda: None)
    session.start()
    session.attach(mailbox)
    session.settle()
    assert session.trouble is not None
    assert "container" in session.trouble
    assert "trouble" in str(mailbox.take())
    with pytest.raises(UsageError, match="container"):
        session.snapshot()
    session.close()


def test_an_engine_that_fails_stops_the_clock_and_says_why(session: Session) -> None:
    session.pause()
    session.start()
    session.settle()
    session.show.simulation.advance = _broken  # type: ignore[method-assign]
    session.play()
    until(lambda: session.trouble)
    assert session.trouble == "no progress"
    assert not session.playing
    session.reset().result(5)
    assert session.trouble is None


def _broken(**_: float) -> None:
    from gasbox.errors import DynamicsError

    raise DynamicsError("no progress")


def test_highlighted_are_those_of_the_bin(paused: Session) -> None:
    sample = paused.sample()
    assert sample is not None
    state = sample.state
    speed = np.sqrt((state.velocity**2).sum(axis=1))
    mailbox = open_mailbox(paused)
    paused.highlight(1, 0.05, 0.15)
    paused.settle()
    lit = frames(mailbox)[-1].highlight
    np.testing.assert_array_equal(lit, (state.species == 1) & (speed >= 0.05) & (speed < 0.15))
    assert lit is not None
    assert lit.any()
    mailbox.ack(1, 1)
    paused.highlight(0, 0.0, 0.005, "energy")
    paused.settle()
    energy = 0.5 * state.mass * speed**2
    np.testing.assert_array_equal(frames(mailbox)[-1].highlight, (state.species == 0) & (energy < 0.005))
    mailbox.ack(2, 2)
    paused.clear_highlight()
    paused.settle()
    assert frames(mailbox)[-1].highlight is None


def test_a_followed_disc_is_in_the_frame(paused: Session) -> None:
    mailbox = open_mailbox(paused)
    paused.follow(33)
    paused.settle()
    sample = paused.sample()
    assert sample is not None
    frame = frames(mailbox)[-1]
    assert frame.row == 33
    followed = paused.followed()
    assert followed is not None
    assert followed.position == tuple(sample.state.position[33])
    assert followed.speed == pytest.approx(np.linalg.norm(sample.state.velocity[33]))
    assert paused.id_of_row(33) == 33
    paused.follow(5000)
    paused.settle()
    assert paused.followed() is None


@pytest.mark.parametrize("row", [None, -1, 50, "3", 1.5])
def test_a_row_that_is_none(paused: Session, row: Any) -> None:
    assert paused.id_of_row(row) is None


def test_gas_and_speed_are_handed_over(session: Session) -> None:
    session.start()
    session.set_speed(3.0)
    session.pause()
    session.step().result(5)
    gas_itself = session.show.simulation
    heir = Session(session.origin, unwatched=True, simulate=FreeFlight)
    session.hand_over(heir)
    heir.settle()
    assert heir.show.simulation is gas_itself
    assert (heir.speed, heir.playing) == (3.0, False)
    with pytest.raises(UsageError, match="ended"):
        session.settle()
    heir.close()


def test_closing_ends_the_thread() -> None:
    before = threading.active_count()
    session = Session(gas(), unwatched=True, simulate=FreeFlight)
    session.start()
    session.settle()
    assert threading.active_count() == before + 1
    session.close()
    assert threading.active_count() == before


def test_session_wire_format_and_stream_know_no_page_framework() -> None:
    program = """
import sys
import gasbox.app.protocol, gasbox.app.registry, gasbox.app.security, gasbox.app.session, gasbox.app.stream
sys.exit("nicegui" in sys.modules)
"""
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0
