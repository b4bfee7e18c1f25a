"""What the grids of the engines have in common: classes of sizes, one grid each, and the cells of a direction."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import inlined_kernel

__all__ = ["cell_of", "classes", "span"]


def classes(radius: NDArray[np.float64], ratio: float) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    """Sort radii into classes whose largest member is at most `ratio` times the smallest.

    Returns
    -------
    level : (n,) int32, finest class 0
    largest : (levels,) float64, largest radius in each class; one class of radius 1 without any discs
    """
    if not radius.size:
        return np.zeros(0, np.int32), np.ones(1)
    sizes, inverse = np.unique(radius, return_inverse=True)
    level_of_size = np.zeros(sizes.size, np.int32)
    smallest, largest = sizes[:1].tolist(), sizes[:1].tolist()
    for k, size in enumerate(sizes):
        if size > ratio * smallest[-1]:
            smallest.append(size)
            largest.append(size)
        largest[-1] = size
        level_of_size[k] = len(smallest) - 1
    return level_of_size[inverse].astype(np.int32), np.array(largest, np.float64)


@inlined_kernel
def cell_of(coordinate: float, per_length: float, cells: int) -> int:
    """Column (or row) of a coordinate, with `per_length` of them in a length; what lies outside is in the outermost."""
    return min(max(int(coordinate * per_length), 0), cells - 1)


@inlined_kernel
def span(cell: int, cells: int, periodic: bool) -> tuple[int, int]:
    """First and last offset of the neighbours of a cell in one direction, each cell once however few there are."""
    if periodic:
        if cells >= 3:
            return -1, 1
        return 0, cells - 1
    return max(-1, -cell), min(1, cells - 1 - cell)
