"""Where a rising function takes a value: Newton's steps, kept between two bounds."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

import numpy as np

from gasbox.theory.real import Real, pick

__all__ = ["rising_root"]

_STEPS: Final = 200
"""More than bisection alone would need for the last bit of a double."""
_CLOSE: Final = 4.0 * np.finfo(np.float64).eps


def rising_root(function: Callable[[Any], tuple[Any, Any]], low: Real, high: Real) -> Real:
    """Where a rising function is zero, to the last bits; an array is solved element by element.

    Parameters
    ----------
    function : of an argument shaped as the bounds, gives the value there and the slope, > 0
    low, high : bounds with the root between them; if there is none, the nearer bound is returned
    """
    below: Any = low
    above: Any = high
    root: Any = high
    for _ in range(_STEPS):
        value, slope = function(root)
        below = pick(value <= 0.0, root, below)
        above = pick(value >= 0.0, root, above)
        step = root - value / slope
        following = pick((step >= below) & (step <= above), step, 0.5 * (below + above))
        moved = np.abs(following - root) > _CLOSE * np.maximum(np.abs(following), 1.0)
        root = following
        if not np.any(moved):
            break
    result: Real = root
    return result
