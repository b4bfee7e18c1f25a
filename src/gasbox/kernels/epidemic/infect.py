"""Infection of those who are near. Symbols: i susceptible, j infectious, k place in the list, c cell, x y position."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.epidemic.stages import SUSCEPTIBLE
from gasbox.kernels.grid import span
from gasbox.kernels.hall.random import uniform
from gasbox.kernels.walk.chance import words
from gasbox.kernels.walk.filing import cell_at, file_people, shortest
from gasbox.kernels.walk.tables import Files, Ground
from gasbox.rng import Stream

__all__ = ["Crowd", "Found", "infect"]

_STREAM = int(Stream.INFECTION)


class Crowd(NamedTuple):
    """People, one row for each.

    Attributes
    ----------
    id : (n,) int64
    position : (n, 2) float64 [length]
    stage : (n,) int8, as in `stages`
    zone : (n,) int64, only those of one zone infect each other; below 0, nobody
    burden : (n,) float64 [time], of those who infect: for how long since the last look
    """

    id: NDArray[np.int64]
    position: NDArray[np.float64]
    stage: NDArray[np.int8]
    zone: NDArray[np.int64]
    burden: NDArray[np.float64]


class Found(NamedTuple):
    """Who was infected: `row`, by whom (row `by`), and after which `part` of the time since the last look: (n,)."""

    row: NDArray[np.int64]
    by: NDArray[np.int64]
    part: NDArray[np.float64]


@bare_kernel
def infect(
    crowd: Crowd,
    who: NDArray[np.int64],
    files: Files,
    near: NDArray[np.uint8],
    ground: Ground,
    radius: float,
    rate: float,
    turn: int,
    seed: NDArray[np.int64],
    found: Found,
) -> int:
    """Infect susceptible people near infectious ones; write them to `found` and return how many they are.

    The probability is 1 - exp(-rate sum of burden), the sum over all infectious people within the radius.

    Parameters
    ----------
    who : (k,) int64, rows of the infectious, ascending
    files : cells not narrower than `radius`
    near : (cells,) uint8, room for marks
    radius : [length]
    rate : of infection by one infectious person within the radius [1/time]
    turn : number of this look, for the random numbers
    """
    file_people(crowd.position, who, files, ground)
    _mark(files, who.shape[0], near, ground)
    count = 0
    for i in range(crowd.id.shape[0]):
        if crowd.stage[i] != SUSCEPTIBLE:
            continue
        c = cell_at(crowd.position[i, 0], crowd.position[i, 1], files, ground)
        if near[c] == 0 or crowd.zone[i] < 0:
            continue
        burden, _ = _around(crowd, i, c, files, ground, radius, math.inf)
        if burden == 0.0:
            continue
        drawn = words(crowd.id[i], turn, _STREAM, seed)
        waiting = -math.log(uniform(drawn[0], drawn[1]))
        if waiting >= rate * burden:
            continue
        share = burden * uniform(drawn[2], drawn[3])
        found.row[count] = i
        found.by[count] = _around(crowd, i, c, files, ground, radius, share)[1]
        found.part[count] = waiting / (rate * burden)
        count += 1
    return count


@bare_kernel
def _mark(files: Files, count: int, near: NDArray[np.uint8], ground: Ground) -> None:
    """Mark all cells in or beside which one of the first `count` who were filed stands."""
    near[:] = 0
    columns, rows = files.cells[0], files.cells[1]
    across, along = ground.period_x < math.inf, ground.period_y < math.inf
    for k in range(count):
        column, line = files.at[k] % columns, files.at[k] // columns
        low, high = span(line, rows, along)
        left, right = span(column, columns, across)
        for up in range(low, high + 1):
            for beside in range(left, right + 1):
                near[(line + up) % rows * columns + (column + beside) % columns] = 1


@inlined_kernel
def _around(
    crowd: Crowd, i: int, cell: int, files: Files, ground: Ground, radius: float, share: float
) -> tuple[float, int]:
    """Sum of the burdens within the radius of i, and the one with whom it reaches `share` (the last, if none)."""
    columns, rows = files.cells[0], files.cells[1]
    x, y = crowd.position[i, 0], crowd.position[i, 1]
    column, line = cell % columns, cell // columns
    low, high = span(line, rows, ground.period_y < math.inf)
    left, right = span(column, columns, ground.period_x < math.inf)
    burden, last = 0.0, -1
    for up in range(low, high + 1):
        for beside in range(left, right + 1):
            c = (line + up) % rows * columns + (column + beside) % columns
            for entry in range(files.begin[c], files.begin[c + 1]):
                dx = shortest(files.x[entry] - x, ground.period_x)
                dy = shortest(files.y[entry] - y, ground.period_y)
                if dx * dx + dy * dy > radius * radius:
                    continue
                j = files.row[entry]
                if crowd.zone[j] != crowd.zone[i] or burden >= share:
                    continue
                burden += crowd.burden[j]
                last = j
    return burden, last
