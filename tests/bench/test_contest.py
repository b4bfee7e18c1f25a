from __future__ import annotations

import time

from gasbox.bench import contest


class Clockwork:
    """Does one unit in each `pace` seconds, and notes how many it was asked for."""

    def __init__(self, name: str, pace: float) -> None:
        self.name, self._pace = name, pace
        self.calls: list[tuple[str, int]] = []

    def work(self, portions: int) -> float:
        self.calls.append((self.name, portions))
        time.sleep(portions * self._pace)
        return portions


def test_rates_are_amounts_over_time_and_ratios_are_to_the_first() -> None:
    fast, slow = Clockwork("fast", 0.001), Clockwork("slow", 0.004)
    results = contest("task", "units", 2, [fast, slow], rounds=3, seconds=0.02)
    assert [result.program for result in results] == ["fast", "slow"]
    assert all(len(result.rates) == 3 for result in results)
    # A sleep is never shorter than asked for; how much longer depends on the machine.
    assert max(results[0].rates) <= 1000
    assert max(results[1].rates) <= 250
    assert results[0].ratio == 1
    assert results[1].ratio > 1


def test_they_take_turns_and_each_round_is_one_call() -> None:
    shared: list[tuple[str, int]] = []
    contenders = [Clockwork("a", 0.001), Clockwork("b", 0.001)]
    for contender in contenders:
        contender.calls = shared
    contest("task", "units", 2, contenders, rounds=2, seconds=0.01)
    # In the trial a call compiles, and the next ones grow until one takes half of the time; sleeps are never too short.
    longest = max(portions for _, portions in shared)
    assert longest <= 8
    assert shared[:2] == [("a", 1), ("a", 1)]
    assert [name for name, _ in shared[-4:]] == ["a", "b"] * 2


def test_a_first_call_that_compiles_is_not_counted() -> None:
    class Compiled(Clockwork):
        def work(self, portions: int) -> float:
            if not self.calls:
                time.sleep(0.1)
            return super().work(portions)

    contender = Compiled("late", 0.0001)
    contest("task", "units", 2, [contender], rounds=1, seconds=0.02)
    assert contender.calls[-1][1] > 1


def test_a_pause_in_the_trial_makes_no_round_too_short() -> None:
    class Paused(Clockwork):
        def work(self, portions: int) -> float:
            if len(self.calls) == 1:
                time.sleep(0.1)
            return super().work(portions)

    contender = Paused("paused", 0.0001)
    (result,) = contest("task", "units", 2, [contender], rounds=3, seconds=0.02)
    assert contender.calls[1][1] == 1
    assert min(portions for _, portions in contender.calls[-2:]) > 1
    assert len(result.rates) == 3
