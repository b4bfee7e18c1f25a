"""Histograms averaged over a while, so that the eye sees the law and not the noise."""

from __future__ import annotations

import math
from collections import deque

import numpy as np
from numpy.typing import NDArray

__all__ = ["CHOICES", "Smoothing"]

CHOICES: dict[float, str] = {0.0: "none", 1.0: "1 s", 5.0: "5 s", 20.0: "20 s", math.inf: "since start"}
"""Windows [seconds of real time] that can be chosen, and what they are called."""


class Smoothing:
    """The mean of the counts seen within a window of real time.

    Attributes
    ----------
    window : [s]; 0 shows each moment by itself, infinity averages over all that was seen
    """

    def __init__(self, window: float = 0.0) -> None:
        self.window = window
        self._seen: deque[tuple[float, NDArray[np.float64]]] = deque()
        self._sum: NDArray[np.float64] | None = None
        self._count = 0

    def forget(self) -> None:
        """Start anew: another gas, or other bins."""
        self._seen.clear()
        self._sum = None
        self._count = 0

    def choose(self, window: float) -> None:
        """Change the window [s]; what was seen before does not count any more."""
        self.window = window
        self.forget()

    def mean(self, now: float, counts: NDArray[np.float64]) -> NDArray[np.float64]:
        """Take in the counts at the real time `now` [s], and return the mean over the window."""
        if self.window == 0:
            return counts
        self._sum = counts.astype(float) if self._sum is None else self._sum + counts
        self._count += 1
        if math.isfinite(self.window):
            self._seen.append((now, counts))
            self._drop(now - self.window)
        return self._sum / self._count

    def _drop(self, start: float) -> None:
        while len(self._seen) > 1 and self._seen[0][0] <= start:
            assert self._sum is not None
            self._sum = self._sum - self._seen.popleft()[1]
            self._count -= 1
