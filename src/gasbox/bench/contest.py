"""Measures several programs at the same task, in turns, so that a busy neighbour disturbs all alike."""

from __future__ import annotations

import statistics
import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, Protocol

__all__ = ["OURS", "PLAIN", "Contender", "Result", "contest"]

OURS: Final = "gasbox"
PLAIN: Final = "plain loops"
"""The readable engines of `gasbox.bench.plain`."""


class Contender(Protocol):
    """A gas in some program, set up and ready to go on."""

    name: str

    def work(self, portions: int) -> float:
        """Go on by `portions` (at least one), and say how much was done, in the unit of the rate."""
        ...


@dataclass(frozen=True)
class Result:
    """The rates of one program at one task.

    Attributes
    ----------
    task, unit : what is done, and what is counted
    particles : how many there are
    program : who did it
    rates : amount a second [1/s], one for each round
    ratio : median rate of the first program over this one's; above 1 this one is slower
    """

    task: str
    unit: str
    particles: int
    program: str
    rates: tuple[float, ...]
    ratio: float

    @property
    def median(self) -> float:
        """Median rate [1/s]."""
        return statistics.median(self.rates)


def contest(
    task: str, unit: str, particles: int, contenders: Sequence[Contender], rounds: int, seconds: float
) -> list[Result]:
    """Let all work in turns, `rounds` times for at least half of `seconds` [s] each, after a trial.

    The first contender is the one that the others are compared with.
    """
    turns = [_Turns(contender, seconds) for contender in contenders]
    for _ in range(rounds):
        for turn in turns:
            turn.take()
    first = statistics.median(turns[0].rates)
    return [
        Result(task, unit, particles, turn.name, tuple(turn.rates), first / statistics.median(turn.rates))
        for turn in turns
    ]


class _Turns:
    """The rounds of one contender, each a single call, since looking at many particles costs time as well."""

    def __init__(self, contender: Contender, seconds: float) -> None:
        self.name = contender.name
        self.rates: list[float] = []
        self._work, self._least = contender.work, seconds / 2
        self._portions = 1
        self._work(1)  # compiles, or loads what was compiled
        self._rate()

    def take(self) -> None:
        """Work for one round."""
        self.rates.append(self._rate())

    def _rate(self) -> float:
        """Amount a second [1/s] in the first call that is long enough; each call is twice as long as the one before.

        Later rounds begin where this one ended. A pause in the trial thus does no harm: it made the portions too few.
        """
        while True:
            begin = time.perf_counter()
            done = self._work(self._portions)
            spent = time.perf_counter() - begin
            if spent >= self._least:
                return done / spent
            self._portions *= 2
