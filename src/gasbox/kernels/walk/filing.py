"""People by cell. Symbols: c cell, x y position."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.grid import cell_of
from gasbox.kernels.walk.tables import Files, Ground

__all__ = ["cell_at", "file_people", "shortest"]


@inlined_kernel
def cell_at(x: float, y: float, files: Files, ground: Ground) -> int:
    """Cell of a position [length]."""
    column = cell_of(x, files.cells[0] / ground.size[0], files.cells[0])
    return cell_of(y, files.cells[1] / ground.size[1], files.cells[1]) * files.cells[0] + column


@inlined_kernel
def shortest(way: float, period: float) -> float:
    """A difference of coordinates [length] between the nearest images."""
    if way > 0.5 * period:
        return way - period
    if way < -0.5 * period:
        return way + period
    return way


@bare_kernel
def file_people(position: NDArray[np.float64], who: NDArray[np.int64], files: Files, ground: Ground) -> None:
    """File the rows `who` (k,), in ascending order, by the cell of their positions (n, 2) [length]."""
    begin, row, at = files.begin, files.row, files.at
    begin[:] = 0
    for k in range(who.shape[0]):
        i = who[k]
        at[k] = cell_at(position[i, 0], position[i, 1], files, ground)
        begin[at[k] + 2] += 1
    for c in range(2, begin.shape[0]):
        begin[c] += begin[c - 1]
    # Now begin[c + 1] is where cell c begins; while they are filed it moves on to its end.
    for k in range(who.shape[0]):
        i, place = who[k], begin[at[k] + 1]
        row[place], files.x[place], files.y[place] = i, position[i, 0], position[i, 1]
        begin[at[k] + 1] += 1
