"""A round end for the vertical axis of a chart, that stays where it is as long as it can."""

from __future__ import annotations

import math
from collections import deque
from typing import Final

from gasbox.theory.ranges import rounded_up

__all__ = ["Ceiling", "interval"]

_MEMORY: Final = 4.0
"""Seconds that a high value is remembered."""
_INTERVALS: Final = {
    1.0: 0.5,
    1.2: 0.4,
    1.5: 0.5,
    2.0: 0.5,
    2.5: 0.5,
    3.0: 1.0,
    4.0: 1.0,
    5.0: 1.0,
    6.0: 2.0,
    8.0: 2.0,
}
"""Distance of the marks by the leading digits of the axis' end."""


def interval(end: float) -> float:
    """Distance of the marks on an axis from 0 to `end`, so that they divide it and count whole particles."""
    power = 10.0 ** math.floor(math.log10(end))
    nearest = min(_INTERVALS, key=lambda step: abs(step - end / power))
    return max(1.0, float(f"{_INTERVALS[nearest] * power:.6g}"))


class Ceiling:
    """The upper end of an axis of counts: it grows at once, and comes down only when it was long far too high."""

    def __init__(self) -> None:
        self.value = 0.0
        self._recent: deque[tuple[float, float]] = deque()

    def forget(self) -> None:
        """Start anew."""
        self.value = 0.0
        self._recent.clear()

    def cover(self, now: float, highest: float) -> float:
        """The end of the axis after `highest` was seen at the real time `now` [s]."""
        self._recent.append((now, highest))
        while self._recent[0][0] < now - _MEMORY:
            self._recent.popleft()
        most = max(value for _, value in self._recent)
        wanted = float(math.ceil(rounded_up(max(1.08 * most, 2.0))))
        if wanted > self.value or wanted < 0.6 * self.value:
            self.value = wanted
        return self.value
