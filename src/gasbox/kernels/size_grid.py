"""Cells for discs of very different sizes: one grid for each class of size.

A class holds radii within a factor of two, and its cells are at least as wide as its largest disc. Whatever the
ratio of sizes, a disc so meets a bounded number of cells of its own class and of each coarser one.

Symbols: k class, i j discs, r radius, x y centre, c cell.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import kernel

__all__ = ["SizeGrid", "around", "cell", "first_cell", "last_cell", "nearest", "overlaps_any", "put", "take"]


class SizeGrid(NamedTuple):
    """Linked lists of discs, by class of size and cell. All arrays are changed in place.

    Attributes
    ----------
    size : (2,) float64 [length], the box
    periodic : (2,) bool
    top : (classes,) float64 [length], largest radius of each class, the coarsest first
    cells : (classes, 2) int64, number of cells along x and y
    width : (classes, 2) float64 [length], of one cell; at least ``2 * top`` or the whole side
    offset : (classes,) int64, where the class begins in `head`
    head : (all cells,) int32, first disc of each cell, -1 for none
    next : (n,) int32, next disc in the same cell, -1 for none
    size_class : (n,) int32, class of each disc
    """

    size: NDArray[np.float64]
    periodic: NDArray[np.bool_]
    top: NDArray[np.float64]
    cells: NDArray[np.int64]
    width: NDArray[np.float64]
    offset: NDArray[np.int64]
    head: NDArray[np.int32]
    next: NDArray[np.int32]
    size_class: NDArray[np.int32]


@kernel
def cell(grid: SizeGrid, k: int, x: float, y: float) -> int:
    """Index in `head` of the cell of class `k` that holds (x, y); what lies outside belongs to the edge."""
    column = min(max(math.floor(x / grid.width[k, 0]), 0), grid.cells[k, 0] - 1)
    row = min(max(math.floor(y / grid.width[k, 1]), 0), grid.cells[k, 1] - 1)
    return int(grid.offset[k] + row * grid.cells[k, 0] + column)


@kernel
def put(grid: SizeGrid, i: int, x: float, y: float) -> None:
    """Enter disc `i` into its cell."""
    c = cell(grid, grid.size_class[i], x, y)
    grid.next[i] = grid.head[c]
    grid.head[c] = i


@kernel
def take(grid: SizeGrid, i: int, x: float, y: float) -> None:
    """Take disc `i`, entered at (x, y), out of its cell."""
    c = cell(grid, grid.size_class[i], x, y)
    if grid.head[c] == i:
        grid.head[c] = grid.next[i]
        return
    j = grid.head[c]
    while grid.next[j] != i:
        j = grid.next[j]
    grid.next[j] = grid.next[i]


@kernel
def first_cell(low: float, high: float, width: float, count: int, periodic: bool) -> int:
    """First of `count` cells of this width that meets [low, high]; in a periodic direction it may be negative."""
    # The margin keeps rounding at the edge of a cell from hiding a neighbour.
    first = math.floor(low / width - 1e-9)
    if periodic:
        last = math.floor(high / width + 1e-9)
        return 0 if last - first + 1 >= count else first
    return min(max(first, 0), count - 1)


@kernel
def last_cell(low: float, high: float, width: float, count: int, periodic: bool) -> int:
    """Last of `count` cells of this width that meets [low, high]; none comes twice from the first to the last."""
    last = math.floor(high / width + 1e-9)
    if periodic:
        first = math.floor(low / width - 1e-9)
        return count - 1 if last - first + 1 >= count else last
    return min(max(last, 0), count - 1)


@kernel
def around(number: int, count: int) -> int:
    """Cell `number` of `count`, at most once round the period; quicker than a division."""
    if number < 0:
        return number + count
    return number - count if number >= count else number


@kernel
def nearest(difference: float, length: float, periodic: bool) -> float:
    """`difference` [length] to the nearest image."""
    return difference - length * math.floor(difference / length + 0.5) if periodic else difference


@kernel
def overlaps_any(
    grid: SizeGrid,
    position: NDArray[np.float64],
    radius: NDArray[np.float64],
    i: int,
    x: float,
    y: float,
    r: float,
) -> bool:
    """Whether a disc of radius `r` at (x, y) would overlap a disc of the grid other than `i`. Touching is none."""
    for k in range(grid.top.shape[0]):
        reach = r + grid.top[k]
        columns, rows = grid.cells[k, 0], grid.cells[k, 1]
        left = first_cell(x - reach, x + reach, grid.width[k, 0], columns, grid.periodic[0])
        right = last_cell(x - reach, x + reach, grid.width[k, 0], columns, grid.periodic[0])
        bottom = first_cell(y - reach, y + reach, grid.width[k, 1], rows, grid.periodic[1])
        top = last_cell(y - reach, y + reach, grid.width[k, 1], rows, grid.periodic[1])
        for row in range(bottom, top + 1):
            start = grid.offset[k] + around(row, rows) * columns
            for column in range(left, right + 1):
                j = grid.head[start + around(column, columns)]
                while j >= 0:
                    dx = nearest(x - position[j, 0], grid.size[0], grid.periodic[0])
                    dy = nearest(y - position[j, 1], grid.size[1], grid.periodic[1])
                    if dx * dx + dy * dy < (r + radius[j]) ** 2 and j != i:
                        return True
                    j = grid.next[j]
    return False
