"""Numbers over time in bounded memory: when full, every second one is let go, and fewer are kept from then on."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

__all__ = ["History"]

_MOST: Final = 400
"""Points of a curve; a chart has not many more pixels."""


class History:
    """Rows of numbers, one for each moment that was kept.

    Attributes
    ----------
    time : of each row [time]
    rows : of equal length
    """

    def __init__(self) -> None:
        self.time: list[float] = []
        self.rows: list[tuple[float, ...]] = []
        self._stride = 1
        self._seen = 0

    def add(self, time: float, row: tuple[float, ...]) -> None:
        """Take in a row, unless the time is that of the last one; an earlier time begins anew."""
        if self.time and (time < self.time[-1] or len(row) != len(self.rows[-1])):
            self.time, self.rows, self._stride, self._seen = [], [], 1, 0
        if self.time and time == self.time[-1]:
            return
        # The newest row is always kept; it makes room if it is none that stays.
        if self._seen % self._stride and len(self.time) > 1:
            self.time.pop()
            self.rows.pop()
        self._seen += 1
        self.time.append(time)
        self.rows.append(row)
        if len(self.time) > _MOST:
            self.time, self.rows = self.time[::2], self.rows[::2]
            self._stride *= 2

    def column(self, number: int) -> NDArray[np.float64]:
        """(rows, 2) float64: time and one of the numbers."""
        values = [(time, row[number]) for time, row in zip(self.time, self.rows, strict=True)]
        return np.array(values, np.float64).reshape(-1, 2)
