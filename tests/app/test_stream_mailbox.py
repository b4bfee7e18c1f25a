"""Between the thread and the socket: a bounded box that drops frames and never texts."""

from __future__ import annotations

import pytest
from free_flight import FakeClock

from gasbox.app.mailbox import NO_ACK_LIMIT, WINDOW, Mailbox

pytestmark = pytest.mark.small


@pytest.fixture
def clock() -> FakeClock:
    return FakeClock()


@pytest.fixture
def mailbox(clock: FakeClock) -> Mailbox:
    return Mailbox(ring=lambda: None, clock=clock)


def test_only_the_newest_frame_waits(mailbox: Mailbox) -> None:
    for number in range(100):
        mailbox.put_frame(bytes([number]))
    assert mailbox.take() == bytes([99])
    assert mailbox.take() is None
    assert mailbox.dropped == 99


def test_no_more_than_the_window_is_on_its_way(mailbox: Mailbox) -> None:
    taken = []
    for number in range(10):
        mailbox.put_frame(bytes([number]))
        taken.append(mailbox.take())
    assert taken == [b"\0", b"\1", *[None] * 8]
    assert WINDOW == 2
    mailbox.ack(1, 1)
    assert mailbox.take() == bytes([9])
    assert mailbox.take() is None


def test_acks_are_cumulative(mailbox: Mailbox) -> None:
    for _ in range(2):
        mailbox.put_frame(b"frame")
        mailbox.take()
    mailbox.ack(2, 1)  # one ack for both, and only one was drawn
    mailbox.put_frame(b"a")
    assert mailbox.take() == b"a"
    mailbox.put_frame(b"b")
    assert mailbox.take() == b"b"


def test_an_ack_for_more_than_was_sent_opens_nothing(mailbox: Mailbox) -> None:
    mailbox.ack(10**9, 10**9)
    for _ in range(5):
        mailbox.put_frame(b"frame")
        mailbox.take()
    mailbox.put_frame(b"frame")
    assert mailbox.take() is None


def test_texts_come_first_and_all(mailbox: Mailbox) -> None:
    mailbox.put_frame(b"frame")
    mailbox.put_text("one")
    mailbox.put_text("two")
    assert [mailbox.take() for _ in range(4)] == ["one", "two", b"frame", None]


def test_only_the_newest_view_waits_and_goes_out_before_its_frame(mailbox: Mailbox) -> None:
    for number in range(100):
        mailbox.put_view(f"view {number}")
        mailbox.put_frame(bytes([number]))
    assert [mailbox.take() for _ in range(3)] == ["view 99", bytes([99]), None]
    mailbox.put_view("while nothing moves")
    assert [mailbox.take() for _ in range(2)] == ["while nothing moves", None]


def test_a_reader_that_is_slow_gets_no_views_either(mailbox: Mailbox) -> None:
    for _ in range(WINDOW):
        mailbox.put_frame(b"frame")
        mailbox.take()
    mailbox.put_view("old")
    mailbox.put_view("new")
    assert mailbox.take() is None
    mailbox.ack(1, 1)
    assert [mailbox.take() for _ in range(2)] == ["new", None]


def test_a_new_table_makes_the_waiting_frame_stale(mailbox: Mailbox) -> None:
    mailbox.put_frame(b"old")
    mailbox.put_text("table", stale=True)
    mailbox.put_frame(b"new")
    assert [mailbox.take() for _ in range(3)] == ["table", b"new", None]


def test_who_looks(mailbox: Mailbox, clock: FakeClock) -> None:
    clock.now += 100.0
    assert mailbox.is_watched()  # nothing was sent, so no ack is missing
    mailbox.put_frame(b"frame")
    mailbox.take()
    clock.now += NO_ACK_LIMIT - 0.1
    assert mailbox.is_watched()
    clock.now += 0.2
    assert not mailbox.is_watched()
    mailbox.ack(1, 1)
    assert mailbox.is_watched()
    mailbox.hidden = True
    assert not mailbox.is_watched()
    mailbox.hidden = False
    mailbox.close()
    assert not mailbox.is_watched()


def test_frames_shown_per_second(mailbox: Mailbox, clock: FakeClock) -> None:
    assert mailbox.shown_fps() == 0.0
    for drawn in range(1, 91):
        mailbox.put_frame(b"frame")
        mailbox.take()
        clock.now += 1 / 30
        mailbox.ack(drawn, drawn)
    assert mailbox.shown_fps() == pytest.approx(30, rel=0.05)
    clock.now += 10.0
    assert mailbox.shown_fps() == 0.0
