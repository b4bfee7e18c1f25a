"""How numbers of many runs are spread."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

__all__ = ["QUANTILES", "Spread", "spread"]

QUANTILES: Final = (0.05, 0.5, 0.95)


@dataclass(frozen=True)
class Spread:
    """What is known of a number; nan where runs are too few to tell.

    Attributes
    ----------
    runs : in which it has a value; all others are left out
    mean, standard_deviation, standard_error : of a run, and of the mean
    low, median, high : 5, 50 and 95 of 100 runs lie below
    least, greatest : of all
    """

    runs: int
    mean: float
    standard_deviation: float
    standard_error: float
    low: float
    median: float
    high: float
    least: float
    greatest: float


def spread(values: NDArray[np.float64]) -> Spread:
    """Of values (n,) float64; nan are left out."""
    known = values[np.isfinite(values)]
    count = known.size
    if not count:
        return Spread(0, *[math.nan] * 8)
    deviation = float(np.std(known, ddof=1)) if count > 1 else math.nan
    low, median, high = (float(value) for value in np.quantile(known, QUANTILES))
    return Spread(
        runs=count,
        mean=float(np.mean(known)),
        standard_deviation=deviation,
        standard_error=deviation / math.sqrt(count),
        low=low,
        median=median,
        high=high,
        least=float(np.min(known)),
        greatest=float(np.max(known)),
    )
