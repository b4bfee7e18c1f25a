"""Cells by counting sort, one grid for each class of sizes, so that a mixture costs no more than its parts.

A particle is filed at the level of its size class, in cells at least as wide as the largest diameter there. Whatever
touches it is filed at its own level or at a coarser one within the 3 x 3 cells around it, or looks it up likewise.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box

__all__ = ["Grid", "cell_of", "classes", "file", "grid", "span"]


class Grid(NamedTuple):
    """All levels, finest first; cells of level l are numbered from first[l], row by row.

    Attributes
    ----------
    level : (n,) int32, level of each particle
    columns, rows : (levels,) int64
    first : (levels + 1,) int64
    start : (cells + 1,) int64, first slot of each cell
    order : (n,) int64, particles in the order of their cells
    cell : (n,) int64, cell of each particle
    """

    level: NDArray[np.int32]
    columns: NDArray[np.int64]
    rows: NDArray[np.int64]
    first: NDArray[np.int64]
    start: NDArray[np.int64]
    order: NDArray[np.int64]
    cell: NDArray[np.int64]


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


def grid(radius: NDArray[np.float64], width: float, height: float, ratio: float = 2.0) -> Grid:
    """Empty grids for discs of these radii (n,) [length] in a box of width x height [length]."""
    level, largest = classes(radius, ratio)
    members = np.bincount(level, minlength=largest.size)
    side = np.maximum(2.0 * largest * (1 + 1e-9), 0.5 * np.sqrt(width * height / np.maximum(members, 1)))
    columns = np.maximum(1, np.floor(width / side)).astype(np.int64)
    rows = np.maximum(1, np.floor(height / side)).astype(np.int64)
    first = np.concatenate([np.zeros(1, np.int64), np.cumsum(columns * rows)]).astype(np.int64)
    n = radius.size
    return Grid(
        level,
        columns,
        rows,
        first,
        np.zeros(int(first[-1]) + 1, np.int64),
        np.zeros(n, np.int64),
        np.zeros(n, np.int64),
    )


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


@bare_kernel
def file(
    position: NDArray[np.float64],
    box: Box,
    level: NDArray[np.int32],
    columns: NDArray[np.int64],
    rows: NDArray[np.int64],
    first: NDArray[np.int64],
    start: NDArray[np.int64],
    order: NDArray[np.int64],
    cell: NDArray[np.int64],
) -> None:
    """Sort all particles into their cells, by counting; the arrays from `level` on are those of `Grid`.

    Parameters
    ----------
    position : (n, 2) float64 [length]
    """
    start[:] = 0
    for i in range(position.shape[0]):
        own = level[i]
        column = cell_of(position[i, 0], columns[own] / box.width, columns[own])
        row = cell_of(position[i, 1], rows[own] / box.height, rows[own])
        cell[i] = first[own] + row * columns[own] + column
        start[cell[i] + 1] += 1
    for c in range(1, start.shape[0]):
        start[c] += start[c - 1]
    for i in range(position.shape[0]):
        slot = start[cell[i]]
        order[slot] = i
        start[cell[i]] = slot + 1
    for c in range(start.shape[0] - 1, 0, -1):
        start[c] = start[c - 1]
    start[0] = 0
