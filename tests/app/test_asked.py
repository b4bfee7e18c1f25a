"""What a control has asked for, and how long it waits for it."""

from __future__ import annotations

from free_flight import FakeClock

from gasbox.app.asked import Asked


def test_old_news_is_known_until_what_was_asked_for_is_done_or_refused() -> None:
    clock = FakeClock()
    asked = Asked(clock)
    assert not asked.is_old("easy")
    asked.ask("hard")
    assert asked.is_old("easy")
    assert not asked.is_old("hard")
    asked.ask("medium")
    clock.now += 0.7
    assert asked.is_old("hard")
    clock.now += 0.2
    assert not asked.is_old("hard")


def test_none_is_a_value_as_any_other() -> None:
    asked = Asked(FakeClock())
    asked.ask(None)
    assert asked.is_old(1.0)
    assert not asked.is_old(None)


def test_forth_and_back_does_not_let_go_too_early() -> None:
    asked = Asked(FakeClock())
    asked.ask(6.0)
    asked.ask(5.0)
    assert not asked.is_old(5.0)  # still from before
    assert asked.is_old(6.0)
