"""How simulated time follows real time: ticks, budgets, and an honest account of what was missed."""

from __future__ import annotations

from collections import deque
from typing import ClassVar, Final

__all__ = ["FRAMES_PER_SECOND", "SPEED_LIMITS", "Account", "Slices", "Ticks"]

FRAMES_PER_SECOND: Final = 60
"""Frames of simulated time per second at speed 1, and ticks per second."""
SPEED_LIMITS: Final = (0.1, 100.0)

_MOST_TICKS_AT_ONCE: Final = 4
"""A worker that was late makes up for so many ticks; the rest is told, not caught up."""


class Ticks:
    """A beat of `FRAMES_PER_SECOND` that does not drift, and does not rush after a pause."""

    def __init__(self, now: float) -> None:
        self._start = now
        self._done = 0

    def due(self, now: float) -> int:
        """How many ticks have come since the last call; what exceeds a few is skipped."""
        due = int((now - self._start) * FRAMES_PER_SECOND + 1e-9) - self._done
        if due > 2 * _MOST_TICKS_AT_ONCE:
            self._start, self._done = now, 0
            return _MOST_TICKS_AT_ONCE
        due = min(due, _MOST_TICKS_AT_ONCE)
        self._done += due
        return due

    def wait(self, now: float) -> float:
        """Seconds until the next tick, at least zero."""
        return max(0.0, self._start + (self._done + 1) / FRAMES_PER_SECOND - now)


class Slices:
    """Cuts an advance into pieces, sized from the measured rate.

    A kernel cannot be interrupted; so that a page never hangs, it is only asked for what it can do in the time left.
    Each call costs something whatever it is asked for (projecting all discs), and then something per simulated time.

    Parameters
    ----------
    first : a cautious guess [time] of what takes `FIRST_SECONDS`
    """

    FIRST_SECONDS: ClassVar = 0.004

    def __init__(self, first: float) -> None:
        self._rate = first / self.FIRST_SECONDS
        self._least = 1e-6 * first
        self._overhead = 0.0

    def size(self, seconds: float) -> float:
        """Simulated time [time] for a call that has `seconds` left; never so little that overhead is most of it."""
        return max(self._rate * max(seconds - self._overhead, self._overhead), self._least)

    def costs(self, overhead: float) -> None:
        """A call that was asked for nothing took so many seconds."""
        self._overhead = overhead

    def took(self, simulated: float, seconds: float) -> None:
        """Learn from a slice; what one slice can teach is bounded."""
        self._overhead = min(self._overhead, seconds)
        measured = simulated / max(seconds - self._overhead, 0.2 * seconds, 1e-6)
        self._rate = min(max(0.5 * (self._rate + measured), 0.1 * self._rate), 8.0 * self._rate)


class Account:
    """What was asked for and what was reached over the last second."""

    def __init__(self, frame_interval: float, window: float = 1.0) -> None:
        self._frame_interval = frame_interval
        self._window = window
        self._rows: deque[tuple[float, float, float, float]] = deque()
        """(now, seconds covered, simulated time done, simulated time given up)."""

    def add(self, now: float, seconds: float, done: float, given_up: float) -> None:
        """Book one tick."""
        self._rows.append((now, seconds, done, given_up))
        while self._rows and self._rows[0][0] < now - self._window:
            self._rows.popleft()

    def clear(self) -> None:
        """Forget all: after a pause, a change of speed, or another gas."""
        self._rows.clear()

    def speed(self) -> float | None:
        """The speed reached, 1 for 60 frames of simulated time per second; None before it was measured."""
        seconds = sum(row[1] for row in self._rows)
        if seconds < 0.2:
            return None
        return sum(row[2] for row in self._rows) / (FRAMES_PER_SECOND * self._frame_interval * seconds)

    def keeping_up(self) -> bool:
        """Whether at most a twentieth of what was asked for had to be given up."""
        done = sum(row[2] for row in self._rows)
        given_up = sum(row[3] for row in self._rows)
        return given_up <= 0.05 * (done + given_up)
