"""What an epidemic has come to, counted a few times a day."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.scenario import STAGES
from gasbox.state import Memory
from gasbox.worlds.epidemic.people import ASYMPTOMATIC, EXPOSED, INFECTIOUS, People

__all__ = ["Diary", "infected", "live_reproduction"]

_COLUMNS: Final = ("time", *STAGES, "new_infections", "r", "r_cohort", "total")
_NONE: Final = -1.0
"""Stands for no value, which a saved number cannot."""
_LEAST_PART: Final = 0.1
"""Of the infectious time must be over before one counts in the live estimate."""
_GROWING: Final = (0.01, 0.1)
"""The growth rate is taken while this part of the people has been infected."""
_FEWEST: Final = 10


def infected(counts: NDArray[np.int64]) -> int:
    """How many are exposed or infectious."""
    return int(counts[[EXPOSED, INFECTIOUS, ASYMPTOMATIC]].sum())


def live_reproduction(people: People, time: float) -> float | None:
    """Mean over the infectious of how many each has infected, over the part of the infectious time that is over."""
    now = (people.stage == INFECTIOUS) | (people.stage == ASYMPTOMATIC)
    rows = np.flatnonzero(now & (people.until > people.onset))
    part = (time - people.onset[rows]) / (people.until[rows] - people.onset[rows])
    old = part > _LEAST_PART
    if not old.any():
        return None
    return float(np.mean(people.passed_on[rows[old]] / np.minimum(part[old], 1.0)))


def cohort_reproduction(people: People, since: float) -> float | None:
    """Mean number infected by those whose infectious time has ended since then [time]."""
    rows = np.flatnonzero((people.ended_at > since) & (people.ended_at >= 0.0))
    return float(np.mean(people.passed_on[rows])) if rows.size else None


class Diary:
    """A row every now and then.

    Parameters
    ----------
    day : [time]
    every : time between two rows [time]
    """

    def __init__(self, day: float, every: float) -> None:
        self._day, self._every = day, every
        self._rows: list[tuple[float, ...]] = []
        self.peak = 0, 0.0
        """Greatest number of infected people, and when [time]."""

    def see(self, people: People, time: float, window: float) -> None:
        """Look at the people; write a row if it is time.

        window : time over which those count whose infectious time has ended [time]
        """
        if self._rows and time < self._rows[-1][0] + self._every * (1 - 1e-9):
            return
        counts = people.counts()
        now = infected(counts)
        if now > self.peak[0]:
            self.peak = now, time
        total = int((people.infected_at >= 0.0).sum())
        last = self._rows[-1] if self._rows else None
        fresh = 0.0 if last is None else (total - last[-1]) / (time - last[0]) * self._day
        live, cohort = live_reproduction(people, time), cohort_reproduction(people, time - window)
        estimates = (_NONE if value is None else value for value in (live, cohort))
        self._rows.append((time, *counts.astype(float).tolist(), fresh, *estimates, float(total)))

    def _column(self, name: str) -> NDArray[np.float64]:
        return self._table()[:, _COLUMNS.index(name)]

    def _table(self) -> NDArray[np.float64]:
        return np.array(self._rows, np.float64).reshape(-1, len(_COLUMNS))

    def latest(self, name: str) -> float | None:
        """The last entry of a column."""
        value = self._rows[-1][_COLUMNS.index(name)] if self._rows else _NONE
        return None if value == _NONE else value

    def series(self, stages: Sequence[str]) -> dict[str, NDArray[np.float64]]:
        """Name -> (k,): time, day, these stages, new infections a day, both estimates; nan where there is none."""
        table = self._table()
        found = {"time": table[:, 0], "day": table[:, 0] / self._day}
        for name in (*stages, "new_infections", "r", "r_cohort"):
            column = table[:, _COLUMNS.index(name)].copy()
            column[column == _NONE] = math.nan
            found[name] = column
        return found

    def growth(self, people: int) -> float | None:
        """Rate at which the number of the infected grew at first [1/day], by a straight line through its logarithm."""
        table = self._table()
        total = self._column("total")
        now = table[:, [_COLUMNS.index(STAGES[k]) for k in (EXPOSED, INFECTIOUS, ASYMPTOMATIC)]].sum(axis=1)
        rows = (total >= max(_GROWING[0] * people, _FEWEST)) & (total <= _GROWING[1] * people) & (now > 0)
        # Only up to where it first leaves the range.
        rows &= np.cumsum(total > _GROWING[1] * people) == 0
        if rows.sum() < 4:
            return None
        return float(np.polyfit(table[rows, 0] / self._day, np.log(now[rows]), 1)[0])

    def memory(self) -> Memory:
        """All rows."""
        return {"diary": self._table(), "peak": self.peak[0], "peak_at": self.peak[1]}

    def recall(self, memory: dict[str, Any]) -> None:
        """Go on from what `memory` gave."""
        table = np.asarray(memory["diary"], np.float64).reshape(-1, len(_COLUMNS))
        self._rows = [tuple(row) for row in table.tolist()]
        self.peak = int(memory["peak"]), float(memory["peak_at"])
