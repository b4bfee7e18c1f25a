"""Numbers and arrays alike: what the formulas take is what they give back."""

from __future__ import annotations

from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

__all__ = ["Real", "pick"]

Real = TypeVar("Real", float, NDArray[np.float64])
"""A float, or an array of any shape."""


def pick(condition: Any, there: Any, elsewhere: Any) -> Any:
    """`numpy.where` that gives a number, not an array without axes, for numbers."""
    return np.where(condition, there, elsewhere)[()]
