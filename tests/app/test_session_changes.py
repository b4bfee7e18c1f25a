"""Gravity and walls are changed between two beats, and the browser gets a new table before the next frame."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest
from free_flight import FreeFlight
from session_steps import frames, open_mailbox
from surroundings import walled

from gasbox.app.mailbox import Mailbox
from gasbox.app.session import Session
from gasbox.errors import UsageError
from gasbox.state import MoveWall, SetGravity, SetWall

PISTON = {"right": {"motion": {"kind": "piston", "mass": 50, "pressure": 0.3}}}


@pytest.fixture
def paused() -> Iterator[Session]:
    session = Session(walled(walls=PISTON), simulate=FreeFlight)
    session.pause()
    session.start()
    session.settle()
    yield session
    session.close()


def messages(mailbox: Mailbox) -> list[object]:
    return [
        json.loads(one) if isinstance(one, str) else one for one in iter(mailbox.take, None)
    ]  # fmt: skip


def test_a_change_is_shown_at_once_also_while_time_stands_still(paused: Session) -> None:
    mailbox = open_mailbox(paused)
    messages(mailbox)
    paused.change(SetGravity((0.0, -0.5))).result(5)
    table, *_ = messages(mailbox)
    assert isinstance(table, dict)
    assert (table["kind"], table["gravity"]) == ("table", [0.0, -0.5])
    sample = paused.sample()
    assert sample is not None
    assert sample.geometry.gravity == (0.0, -0.5)
    assert sample.time == 0.0


def test_frames_rely_on_the_new_table(paused: Session) -> None:
    mailbox = open_mailbox(paused)
    first = frames(mailbox)[-1].generation
    paused.change(SetGravity((0.0, -0.5))).result(5)
    mailbox.ack(1, 1)
    paused.step().result(5)
    assert frames(mailbox)[-1].generation == first + 1


def test_what_cannot_be_done_is_told_to_whoever_asked(paused: Session) -> None:
    with pytest.raises(UsageError, match="no wall"):
        paused.change(SetWall("nobody", present=False)).result(5)
    assert paused.trouble is None


def test_a_wall_follows_a_hand_and_only_its_newest_place_counts(paused: Session) -> None:
    for place in (-1.0, -2.0, -3.0):
        paused.drag(1, place)
    paused.drop(1)
    paused.settle()
    changes = [change for _, change in paused.show.simulation.changes]
    moves = [change for change in changes if isinstance(change, MoveWall)]
    assert moves[-1].displacement == -3.0
    assert changes[-1] == SetWall("right", free=True)


def test_a_hand_at_a_wall_that_stays_moves_nothing(paused: Session) -> None:
    paused.drag(0, 5.0)
    paused.drag(77, 5.0)
    paused.drop(0)
    paused.settle()
    assert paused.show.simulation.changes == []
