"""Lists, for each disc, all others within a distance, images across periodic edges each by itself.

Symbols: i j discs, c cell, d2 square of a distance.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import kernel
from gasbox.kernels.grid import cell_of

__all__ = ["count_neighbours", "file_discs", "list_neighbours"]


@kernel
def file_discs(
    position: NDArray[np.float64], size: NDArray[np.float64], cells: NDArray[np.int64]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Sort discs into cells.

    Parameters
    ----------
    position : (n, 2) float64 [length], in the box [0, size]
    size : (2,) float64 [length]
    cells : (2,) int64, columns and rows of cells

    Returns
    -------
    begin : (cells+1,) int64, where each cell begins in `row`
    row : (n,) int64, discs by cell, in ascending order within one
    """
    n = position.shape[0]
    begin = np.zeros(cells[0] * cells[1] + 1, np.int64)
    place = np.empty(n, np.int64)
    for i in range(n):
        column = cell_of(position[i, 0], cells[0] / size[0], cells[0])
        place[i] = cell_of(position[i, 1], cells[1] / size[1], cells[1]) * cells[0] + column
        begin[place[i] + 1] += 1
    for c in range(cells[0] * cells[1]):
        begin[c + 1] += begin[c]
    following = begin[:-1].copy()
    row = np.empty(n, np.int64)
    for i in range(n):
        row[following[place[i]]] = i
        following[place[i]] += 1
    return begin, row


@kernel
def _visit(
    position: NDArray[np.float64],
    size: NDArray[np.float64],
    periodic: NDArray[np.bool_],
    cells: NDArray[np.int64],
    reach: NDArray[np.int64],
    distance: float,
    begin: NDArray[np.int64],
    row: NDArray[np.int64],
    i: int,
    other: NDArray[np.int64],
    way: NDArray[np.float64],
) -> int:
    """Neighbours of disc `i`, written in ascending order to `other` and `way` if there is room; their number."""
    x, y = position[i, 0], position[i, 1]
    column = cell_of(x, cells[0] / size[0], cells[0])
    line = cell_of(y, cells[1] / size[1], cells[1])
    found = 0
    for up in range(line - reach[1], line + reach[1] + 1):
        above = math.floor(up / cells[1])
        if above != 0 and not periodic[1]:
            continue
        for along in range(column - reach[0], column + reach[0] + 1):
            beside = math.floor(along / cells[0])
            if beside != 0 and not periodic[0]:
                continue
            c = (up - above * cells[1]) * cells[0] + along - beside * cells[0]
            for entry in range(begin[c], begin[c + 1]):
                j = row[entry]
                # In this order it is the same from both sides, to the bit.
                dx = (position[j, 0] - x) + beside * size[0]
                dy = (position[j, 1] - y) + above * size[1]
                if dx * dx + dy * dy > distance * distance or (j == i and above == 0 and beside == 0):
                    continue
                if other.shape[0] > 0:
                    # Images of one disc come in the order of their cells, so they stay in order.
                    place = found
                    while place > 0 and other[place - 1] > j:
                        other[place] = other[place - 1]
                        way[place, 0], way[place, 1] = way[place - 1, 0], way[place - 1, 1]
                        place -= 1
                    other[place] = j
                    way[place, 0], way[place, 1] = dx, dy
                found += 1
    return found


@kernel
def count_neighbours(
    position: NDArray[np.float64],
    size: NDArray[np.float64],
    periodic: NDArray[np.bool_],
    cells: NDArray[np.int64],
    reach: NDArray[np.int64],
    distance: float,
    begin: NDArray[np.int64],
    row: NDArray[np.int64],
) -> NDArray[np.int64]:
    """(n+1,) int64: where the neighbours of each disc begin in a list of all; the last entry is their number.

    Parameters
    ----------
    position : (n, 2) float64 [length], in the box [0, size]
    size : (2,) float64 [length]
    periodic : (2,) bool
    cells : (2,) int64, columns and rows of cells
    reach : (2,) int64, how many cells on either side are looked at; reach · size/cells >= distance
    distance : > 0 [length]
    begin, row : as `file_discs` gives them
    """
    n = position.shape[0]
    first = np.zeros(n + 1, np.int64)
    nobody, nowhere = np.empty(0, np.int64), np.empty((0, 2), np.float64)
    for i in range(n):
        first[i + 1] = first[i] + _visit(
            position, size, periodic, cells, reach, distance, begin, row, i, nobody, nowhere
        )
    return first


@kernel
def list_neighbours(
    position: NDArray[np.float64],
    size: NDArray[np.float64],
    periodic: NDArray[np.bool_],
    cells: NDArray[np.int64],
    reach: NDArray[np.int64],
    distance: float,
    begin: NDArray[np.int64],
    row: NDArray[np.int64],
    first: NDArray[np.int64],
    other: NDArray[np.int64],
    way: NDArray[np.float64],
) -> None:
    """Fill the list of neighbours; parameters as in `count_neighbours`.

    Parameters
    ----------
    first : (n+1,) int64, as `count_neighbours` gives it
    other : (m,) int64, written: rows of the neighbours, ascending for each disc
    way : (m, 2) float64 [length], written: from the disc to its neighbour
    """
    for i in range(position.shape[0]):
        if first[i + 1] > first[i]:
            here = slice(first[i], first[i + 1])
            _visit(
                position,
                size,
                periodic,
                cells,
                reach,
                distance,
                begin,
                row,
                i,
                other[here],
                way[here],
            )
