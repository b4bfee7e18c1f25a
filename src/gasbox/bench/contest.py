"""Measures several programs at the same task, in turns, so that a busy neighbour disturbs all alike."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Sequence
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
    """Let all work in turns, `rounds` times for some `seconds` [s] each; a trial before finds out how much that is.

    The first contender is the one that the others are compared with.
    """
    portions = {contender.name: _portions(contender.work, seconds) for contender in contenders}
    rates: dict[str, list[float]] = {name: [] for name in portions}
    for _ in range(rounds):
        for contender in contenders:
            done, spent = _timed(contender.work, portions[contender.name])
            rates[contender.name].append(done / spent)
    medians = {name: statistics.median(measured) for name, measured in rates.items()}
    first = medians[contenders[0].name]
    return [
        Result(task, unit, particles, name, tuple(measured), first / medians[name])
        for name, measured in rates.items()
    ]


def _timed(work: Callable[[int], float], portions: int) -> tuple[float, float]:
    """How much was done, and the seconds that it took."""
    begin = time.perf_counter()
    done = work(portions)
    return done, time.perf_counter() - begin


def _portions(work: Callable[[int], float], seconds: float) -> int:
    """How many portions take about `seconds` [s] in one call."""
    work(1)  # compiles, or loads what was compiled
    portions = 1
    while True:
        _, spent = _timed(work, portions)
        if spent >= seconds / 4:
            return max(1, round(portions * seconds / spent))
        portions *= 2
