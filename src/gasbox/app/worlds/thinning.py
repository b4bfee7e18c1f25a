"""Fewer points of a long curve."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["thinned"]


def thinned(count: int, most: int = 240) -> NDArray[np.int64]:
    """Indices of at most so many (2 or more) of `count` rows, evenly chosen, always with the first and the last."""
    step = max(1, -(-(count - 1) // (most - 1)))
    chosen = np.arange(0, count, step)
    return chosen if not count or chosen[-1] == count - 1 else np.append(chosen, count - 1)
