"""What was measured lately: differences of tallies over a sliding window of real time."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from gasbox.state import Tallies

__all__ = ["Lately", "SlidingWindow"]

_BRIEF = 2.5
"""Seconds of real time."""
_NONE: NDArray[np.float64] = np.zeros(0)


@dataclass(frozen=True)
class Lately:
    """What was added to the tallies over the window, and how much simulated time it spans [time].

    Attributes
    ----------
    displacement : (walls,) float64 [length], half-way between where walls were and are; empty if none moves
    brief : the same for the last few seconds alone; None before they are over
    """

    change: Tallies
    duration: float
    displacement: NDArray[np.float64] = field(default_factory=lambda: _NONE)
    brief: Lately | None = None


@dataclass(frozen=True)
class _Row:
    run: float
    time: float
    tallies: Tallies
    displacement: NDArray[np.float64]

    def since(self, before: _Row, brief: Lately | None = None) -> Lately:
        same = self.displacement.shape == before.displacement.shape
        middle = 0.5 * (self.displacement + before.displacement) if same else self.displacement
        return Lately(self.tallies - before.tallies, self.time - before.time, middle, brief)


class SlidingWindow:
    """Keeps tallies of the last seconds.

    Attributes
    ----------
    seconds : length of the window in real time [s]; while the gas is paused, nothing is forgotten
    """

    def __init__(self, seconds: float = 10.0) -> None:
        self.seconds = seconds
        self._rows: deque[_Row] = deque()
        self._version = -1
        self._run = 0.0
        self._last = 0.0

    def take(
        self,
        now: float,
        version: int,
        time: float,
        tallies: Tallies,
        displacement: NDArray[np.float64] = _NONE,
    ) -> Lately | None:
        """Take in the tallies at simulated `time`; `version` tells one gas from the next.

        Returns
        -------
        What was added within the window, or None before anything has happened.
        """
        if version != self._version or (self._rows and time < self._rows[-1].time):
            self._rows.clear()
            self._version = version
        if not self._rows or time > self._rows[-1].time:
            self._run += min(now - self._last, 1.0) if self._rows else 0.0
            self._rows.append(_Row(self._run, time, tallies, displacement))
            self._forget()
        self._last = now
        return self._lately()

    def _forget(self) -> None:
        while len(self._rows) > 2 and self._rows[1].run <= self._run - self.seconds:
            self._rows.popleft()

    def _lately(self) -> Lately | None:
        if len(self._rows) < 2:
            return None
        newest = self._rows[-1]
        old = (row for row in reversed(self._rows) if row.run <= newest.run - _BRIEF)
        recent = next(old, None)
        return newest.since(self._rows[0], None if recent is None else newest.since(recent))
