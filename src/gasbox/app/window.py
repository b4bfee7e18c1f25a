"""What was measured lately: differences of tallies over a sliding window of real time."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

from gasbox.state import Tallies

__all__ = ["Lately", "SlidingWindow"]


@dataclass(frozen=True)
class Lately:
    """What was added to the tallies over the window, and how much simulated time it spans [time]."""

    change: Tallies
    duration: float


class SlidingWindow:
    """Keeps tallies of the last seconds.

    Attributes
    ----------
    seconds : length of the window in real time [s]; while the gas is paused, nothing is forgotten
    """

    def __init__(self, seconds: float = 10.0) -> None:
        self.seconds = seconds
        self._rows: deque[tuple[float, float, Tallies]] = deque()
        self._version = -1
        self._run = 0.0
        self._last = 0.0

    def take(self, now: float, version: int, time: float, tallies: Tallies) -> Lately | None:
        """Take in the tallies at simulated `time`; `version` tells one gas from the next.

        Returns
        -------
        What was added within the window, or None before anything has happened.
        """
        if version != self._version or (self._rows and time < self._rows[-1][1]):
            self._rows.clear()
            self._version = version
        if not self._rows or time > self._rows[-1][1]:
            self._run += min(now - self._last, 1.0) if self._rows else 0.0
            self._rows.append((self._run, time, tallies))
            self._forget()
        self._last = now
        return self._lately()

    def _forget(self) -> None:
        while len(self._rows) > 2 and self._rows[1][0] <= self._run - self.seconds:
            self._rows.popleft()

    def _lately(self) -> Lately | None:
        if len(self._rows) < 2:
            return None
        _, start, before = self._rows[0]
        _, end, after = self._rows[-1]
        return Lately(after - before, end - start)
