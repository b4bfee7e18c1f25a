"""An observer that averages the histogram of each species over the frames of a run."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gasbox.observe.histograms import Histogram, histogram
from gasbox.state import Contacts, State, Tallies
from gasbox.theory.ranges import Measure

__all__ = ["HistogramAverage"]


class HistogramAverage:
    """Mean number of particles in each bin, over the frames since a time.

    Frames closer together than some five collisions per particle are not independent: their mean is right,
    but its scatter does not shrink as if they were.

    Parameters
    ----------
    edges : for each species its (bins+1,) edges
    quantity : what is counted
    since : frames before this time are left out, so that a transient can pass [time]
    """

    reads_contacts = False

    def __init__(
        self, edges: Sequence[NDArray[np.float64]], quantity: Measure = "speed", since: float = -np.inf
    ) -> None:
        self._edges = [np.asarray(one, dtype=np.float64) for one in edges]
        self._quantity = quantity
        self._since = since
        self._last = -np.inf
        self._rows = self._empty()
        self.frames = 0

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget all frames."""
        self._last, self._rows, self.frames = -np.inf, self._empty(), 0

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Add a frame, unless it is too early or was seen already."""
        if state.time < self._since or state.time <= self._last:
            return
        self._last = state.time
        self.frames += 1
        for species, (edges, row) in enumerate(zip(self._edges, self._rows, strict=True)):
            one = histogram(state, species, edges, self._quantity)
            row += np.concatenate([[one.underflow], one.counts, [one.overflow]])

    def histograms(self) -> list[Histogram]:
        """The mean histogram of each species; empty bins before the first frame."""
        frames = max(self.frames, 1)
        return [
            Histogram(edges, row[1:-1] / frames, float(row[0] / frames), float(row[-1] / frames))
            for edges, row in zip(self._edges, self._rows, strict=True)
        ]

    def _empty(self) -> list[NDArray[np.float64]]:
        return [np.zeros(edges.size + 1) for edges in self._edges]
