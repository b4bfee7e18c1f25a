"""Who looks at a session: what a browser gets, and what happens when nobody looks."""

from __future__ import annotations

import time

import pytest
from free_flight import FreeFlight, gas
from session_steps import frames, open_mailbox, until

from gasbox.app import protocol
from gasbox.app.session import Session


def test_a_browser_gets_the_table_before_the_first_frame(paused: Session) -> None:
    mailbox = open_mailbox(paused)
    text, frame = mailbox.take(), mailbox.take()
    assert isinstance(text, str)
    assert '"kind":"table"' in text
    assert isinstance(frame, bytes)
    assert f'"generation":{protocol.decode_frame(frame).generation}' in text


def test_frames_of_an_old_table_are_never_sent_after_the_new_one(paused: Session) -> None:
    mailbox = open_mailbox(paused)
    paused.load(gas((7,)))
    texts = [message for message in iter(mailbox.take, None) if isinstance(message, str)]
    assert len(texts) == 2
    mailbox.ack(1, 1)
    paused.step().result(5)
    assert {len(frame.species) for frame in frames(mailbox)} == {7}


def test_time_stands_still_while_nobody_looks() -> None:
    session = Session(gas(), simulate=FreeFlight)
    session.start()
    session.settle()
    time.sleep(0.1)
    assert session.show.simulation.time == 0.0

    mailbox = open_mailbox(session)
    until(lambda: session.show.simulation.time > 0.5)

    mailbox.hidden = True
    session.settle()
    until(lambda: not session.show.running)
    hidden = session.show.simulation.time
    time.sleep(0.1)
    assert session.show.simulation.time == hidden

    mailbox.hidden = False
    session.wake()
    until(lambda: session.show.simulation.time > hidden)
    session.close()


def test_without_acks_it_suspends_and_an_ack_wakes_it_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gasbox.app.mailbox.NO_ACK_LIMIT", 0.2)
    session = Session(gas(), simulate=FreeFlight)
    session.start()
    mailbox = open_mailbox(session)
    until(lambda: isinstance(mailbox.take(), bytes))
    until(lambda: not session.show.running)
    stopped = session.show.simulation.time
    time.sleep(0.1)
    assert session.show.simulation.time == stopped
    assert not session.watched
    mailbox.ack(1, 1)
    session.wake()
    until(lambda: session.show.simulation.time > stopped)
    session.close()


def test_a_second_browser_takes_over(paused: Session) -> None:
    first = open_mailbox(paused)
    second = open_mailbox(paused)
    assert first.closed
    assert not second.closed
    paused.audience.detach(first)
    assert paused.audience.attached
    paused.audience.detach(second)
    assert not paused.audience.attached
