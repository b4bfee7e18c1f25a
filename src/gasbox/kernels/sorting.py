"""Sorting in place, without a new array."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel

__all__ = ["sort"]


@bare_kernel
def _sink(
    keys: NDArray[np.int64], along: NDArray[np.int64], key: int, other: int, place: int, size: int
) -> None:
    while True:
        child = 2 * place + 1
        if child >= size:
            break
        if child + 1 < size and keys[child + 1] > keys[child]:
            child += 1
        if keys[child] <= key:
            break
        keys[place] = keys[child]
        along[place] = along[child]
        place = child
    keys[place] = key
    along[place] = other


@bare_kernel
def sort(keys: NDArray[np.int64], along: NDArray[np.int64], size: int) -> None:
    """Sort the first `size` entries of `keys` in ascending order (heapsort); `along` goes with them."""
    for place in range(size // 2 - 1, -1, -1):
        _sink(keys, along, keys[place], along[place], place, size)
    for last in range(size - 1, 0, -1):
        key, other = keys[last], along[last]
        keys[last], along[last] = keys[0], along[0]
        _sink(keys, along, key, other, 0, last)
