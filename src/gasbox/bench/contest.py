"""Measures several programs at the same task, in turns, so that a busy neighbour disturbs all alike."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final, Protocol

__all__ = ["OURS", "Contender", "Result", "contest"]

OURS: Final = "gasbox"


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
    """Let all work in turns, `rounds` times for at least `seconds` [s] each; one round before is not counted.

    The first contender is the one that the others are compared with.
    """
    rates: dict[str, list[float]] = {contender.name: [] for contender in contenders}
    for turn in range(rounds + 1):
        for contender in contenders:
            rate = _rate(contender.work, seconds)
            if turn:
                rates[contender.name].append(rate)
    medians = {name: statistics.median(measured) for name, measured in rates.items()}
    first = medians[contenders[0].name]
    return [
        Result(task, unit, particles, name, tuple(measured), first / medians[name])
        for name, measured in rates.items()
    ]


def _rate(work: Callable[[int], float], seconds: float) -> float:
    done, portions, begin = 0.0, 1, time.perf_counter()
    while True:
        done += work(portions)
        spent = time.perf_counter() - begin
        if spent >= seconds:
            return done / spent
        # Ask the clock seldom, and do not overshoot by much.
        portions = 2 * portions if spent < seconds / 4 else portions
