"""What many runs came to, side by side, in the order of their seeds."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.sweep.members import Member

__all__ = ["Gathered", "gathered"]


@dataclass(frozen=True, eq=False)
class Gathered:
    """All runs of an ensemble.

    Attributes
    ----------
    seeds : (runs,) int64
    values : path -> (runs,) float64; nan in a run that has no such number
    times : (k,) float64 [time]
    series : name -> (runs, k) float64
    """

    seeds: NDArray[np.int64]
    values: dict[str, NDArray[np.float64]]
    times: NDArray[np.float64]
    series: dict[str, NDArray[np.float64]]

    @property
    def is_always_the_same(self) -> bool:
        """Whether no number differs between runs, as where nothing is drawn by chance."""
        return all(np.array_equal(each, np.full_like(each, each[0]), True) for each in self.values.values())


def gathered(members: Iterable[Member], times: NDArray[np.float64]) -> Gathered:
    """Put runs side by side; they may come in any order."""
    ordered = sorted(members, key=lambda member: member.seed)
    names = dict.fromkeys(name for member in ordered for name in member.numbers)
    counted = dict.fromkeys(name for member in ordered for name in member.series)
    nothing = np.full(times.size, np.nan)
    return Gathered(
        np.array([member.seed for member in ordered], np.int64),
        {name: np.array([member.numbers.get(name, np.nan) for member in ordered]) for name in names},
        times,
        {name: np.array([member.series.get(name, nothing) for member in ordered]) for name in counted},
    )
